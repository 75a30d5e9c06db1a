/// @file `kind = "path-generation"`.
#pragma once

#include "problems/problem.hpp"
#include "problems/reading/table_reader.hpp"

namespace cognate::problems::reading {

/// The problem in `document`, complete if no fault was added.
PathProblem read_path_problem(TableReader& document);

}  // namespace cognate::problems::reading
