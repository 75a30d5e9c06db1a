/// @file What a file says of a chain that is to be designed for any purpose: its structure, what is
/// given and bounded, limits, and the search.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "problems/chain/problem.hpp"
#include "problems/chain/read_structure.hpp"
#include "problems/linkage/linkage_limits.hpp"
#include "problems/linkage/read_linkage.hpp"

namespace cognate::problems::reading {

/// What `[mechanism]`, `[bounds]` and the tables of parts say of the topologies `known`, or where
/// there are none, the topology that they define; empty, with a fault, where they define none.
std::vector<Topology> read_topologies(TableReader& document, LinkageTables& tables,
                                      std::vector<Topology> known, const Wanted& wanted);

/// The point whose path counts: `target.point`, which only a chain that the file defines may name;
/// `traced`: that of the type `type`, for the message.
Wanted read_traced(TableReader& target, const std::string& type, std::string_view traced);

/// `target.output`: the names of the two points whose way is the output's direction, which only a
/// chain that the file defines may choose.
std::array<std::string, 2> read_output_link(TableReader& target, const std::string& type);

/// The same, or the name of a slider whose displacement is the output: then the names of its guide
/// and of its pin. `known`: the topologies of the type; empty for a chain that the file defines.
std::array<std::string, 2> read_output(TableReader& target, const std::string& type,
                                       const std::vector<Topology>& known);

/// `transmission_angle_deg` in radians, where it is given and can be kept to.
std::optional<Range> read_chain_transmission(TableReader& constraints);

/// `[constraints]` of paths and motions, but for layers; limits that four-bars alone have are
/// faults.
ChainConstraints read_chain_constraints(TableReader& constraints);

/// Faults limits that four-bars alone have; `taken`: what a chain takes instead, for the message.
void refuse_four_bar_limits(TableReader& constraints, std::string_view taken);

/// Faults what is for chains of dyads alone in a file of a chain with three-pin links, whose limits
/// hold `over` a motion.
void refuse_with_three_pins(TableReader& document, LinkageTables& tables, LimitSpan over);

/// `[solve]`: starts and designs.
void read_chain_solve(TableReader& table, Solve& solve);

/// Faults a `mechanism.type` that is none of `types`: of the rest of the file nothing can be said.
void fault_chain_type(TableReader& document, TableReader& mechanism,
                      std::span<const std::string_view> types);

}  // namespace cognate::problems::reading
