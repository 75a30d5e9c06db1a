/// @file `[tolerance]` of a chain that is yet to be found.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "problems/chain/topology.hpp"
#include "problems/tolerance/read.hpp"

namespace cognate::problems::reading {

/// The table where the document has one: it may name the dimensions and turning joints that chains
/// of every one of these topologies have. Nothing where there is no topology, as that of a faulty
/// file. `unit`: of the error, as in ToleranceScope.
std::optional<Tolerances> read_chain_tolerances(TableReader& document,
                                                std::span<const Topology> topologies,
                                                std::string_view unit);

}  // namespace cognate::problems::reading
