/// @file `[run]`: which motions of a machine are wanted.
#pragma once

#include "problems/machine/problem.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// The request in `table`, complete if no fault was added.
MachineRunRequest read_run(TableReader& table);

/// Whether `task` is among those wanted.
bool asks_for(const MachineRunRequest& run, MachineTask task);

}  // namespace cognate::problems::reading
