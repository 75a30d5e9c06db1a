/// @file `kind = "machine"`.
#pragma once

#include "problems/machine/problem.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// The problem in `document`, complete if no fault was added.
MachineProblem read_machine_problem(TableReader& document);

}  // namespace cognate::problems::reading
