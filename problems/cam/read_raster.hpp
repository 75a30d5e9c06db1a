/// @file `[raster]` of a cam.
#pragma once

#include "problems/cam/problem.hpp"
#include "problems/toml/table_reader.hpp"
#include "problems/toml/table_writer.hpp"

namespace cognate::problems::reading {

/// The table, after everything else of the file but its tolerances.
void read_cam_raster(TableReader& document, CamProblem& problem);

/// Faults free lengths without a value on the raster, or with values without end, and more
/// combinations than can be tried. Everything else has been read without a fault.
void check_cam_raster(TableReader& document, const CamProblem& problem);

/// The table again, where there is one.
Table cam_raster_table(const CamProblem& problem);

}  // namespace cognate::problems::reading
