/// @file Reading of what a body guidance is made of: dimensions on a raster, dimensions that are
/// off.
#pragma once

#include "problems/guidance/problem.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// `[raster]`, on which both dyads are links.
void read_motion_raster(TableReader& document, TableReader& mechanism, MotionProblem& problem);

/// `robust` of `[solve]`, the tolerances being read; both dyads are then links.
void read_motion_robust(TableReader& mechanism, TableReader& solve, MotionProblem& problem);

}  // namespace cognate::problems::reading
