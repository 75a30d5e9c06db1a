/// @file `[[load]]` of a machine: those of an analysis, and those whose size is a function.
#pragma once

#include "problems/machine/problem.hpp"
#include "problems/mechanism/part_names.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// The tables `[[load]]` of `table`, into `problem.mechanism` and `problem.loads`.
void read_machine_loads(TableReader& table, const PartNames& names, MachineProblem& problem);

}  // namespace cognate::problems::reading
