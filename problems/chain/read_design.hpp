/// @file What a file says of a chain that is to be designed for any purpose: its structure, what is
/// given and bounded, limits, and the search.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "problems/chain/read_structure.hpp"
#include "problems/linkage/linkage_limits.hpp"
#include "problems/linkage/read_linkage.hpp"

namespace cognate::problems::reading {

/// What `[mechanism]`, `[bounds]` and the tables of parts say of the topologies `known`, or where
/// there are none, the topology that they define; empty, with a fault, where they define none.
std::vector<Topology> read_topologies(TableReader& document, LinkageTables& tables,
                                      std::vector<Topology> known, const Wanted& wanted);

/// `transmission_angle_deg` in radians, where it is given and can be kept to.
std::optional<Range> read_chain_transmission(TableReader& constraints);

/// Faults limits that four-bars alone have; `taken`: what a chain takes instead, for the message.
void refuse_four_bar_limits(TableReader& constraints, std::string_view taken);

/// `[solve]`: starts and designs.
void read_chain_solve(TableReader& table, Solve& solve);

/// Faults a `mechanism.type` that is none of `types`: of the rest of the file nothing can be said.
void fault_chain_type(TableReader& document, TableReader& mechanism,
                      std::span<const std::string_view> types);

}  // namespace cognate::problems::reading
