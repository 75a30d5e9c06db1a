/// @file Whether the names and the structure of a gear train make sense.
#pragma once

#include "problems/toml/table_reader.hpp"
#include "problems/train/problem.hpp"

namespace cognate::problems::reading {

/// Faults names of no member, meshes that no carrier can hold, and inputs that determine too much
/// or too little. `document` holds the tables of `problem`.
void check_train(TableReader& document, const GearTrainProblem& problem);

}  // namespace cognate::problems::reading
