/// @file Which points a chain has, and on which points before them they close.
#pragma once

#include <optional>

#include "problems/chain/read_parts.hpp"

namespace cognate::problems::reading {

/// The topology that the tables tell, without dimensions; empty, with a fault, where they tell
/// none. `traced`: the traced point, the last where it is empty; `target` is its table.
std::optional<Topology> read_structure(PartTables& parts, TableReader& mechanism,
                                       TableReader& target);

}  // namespace cognate::problems::reading
