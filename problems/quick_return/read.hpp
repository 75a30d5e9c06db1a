/// @file `kind = "quick-return"`.
#pragma once

#include "problems/quick_return/problem.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// Reads every table; what is wrong is faulted, and the problem is then of no use.
QuickReturnProblem read_quick_return_problem(TableReader& document);

}  // namespace cognate::problems::reading
