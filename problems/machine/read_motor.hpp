/// @file `[motor]`: what drives a machine.
#pragma once

#include "problems/machine/problem.hpp"
#include "problems/machine/read_train.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// The motor in `table`, complete if no fault was added.
Motor read_motor(TableReader& table, const TrainContext& context);

}  // namespace cognate::problems::reading
