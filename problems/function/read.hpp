/// @file `kind = "function-generation"`.
#pragma once

#include "problems/function/problem.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// The problem in `document`, complete if no fault was added.
FunctionProblem read_function_problem(TableReader& document);

}  // namespace cognate::problems::reading
