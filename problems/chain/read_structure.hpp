/// @file Which points a chain has, and on which points before them they close.
#pragma once

#include <optional>

#include "problems/chain/wanted_points.hpp"

namespace cognate::problems::reading {

/// The topology that the tables define, without dimensions; empty, with a fault, where they define
/// none. Its `trace` is the last of the points wanted; `target` is the table of their key.
std::optional<Topology> read_structure(PartTables& parts, TableReader& mechanism,
                                       TableReader& target, const Wanted& wanted);

}  // namespace cognate::problems::reading
