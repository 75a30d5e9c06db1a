/// @file `[raster]` of straight lines.
#pragma once

#include "problems/straight_line/problem.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// The raster of a search, all else of which is read.
void read_straight_line_raster(TableReader& document, StraightLineProblem& problem);

/// Refuses a raster beside the theory of contact.
void refuse_raster_of_contact(TableReader& document);

}  // namespace cognate::problems::reading
