/// @file A file of kind = "straight-line".
#pragma once

#include "problems/straight_line/problem.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// Reads the tables of `document`, all but its kind and title.
StraightLineProblem read_straight_line_problem(TableReader& document);

}  // namespace cognate::problems::reading
