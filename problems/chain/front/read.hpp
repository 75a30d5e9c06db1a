/// @file `solve.objectives` of chains: the error, and what it is weighed against.
#pragma once

#include "problems/chain/problem.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// Reads the objectives into `problem`, of which all else is known, and the number of designs.
void read_against(TableReader& solve, ChainPathProblem& problem);

}  // namespace cognate::problems::reading
