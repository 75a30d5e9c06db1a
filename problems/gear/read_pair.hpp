/// @file `kind = "gear-pair"`.
#pragma once

#include "problems/gear/problem.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// Reads every table; what is wrong is faulted, and the problem is then of no use.
GearPairProblem read_gear_pair_problem(TableReader& document);

}  // namespace cognate::problems::reading
