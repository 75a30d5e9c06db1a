/// @file `solve.objectives` of chains: the error, and what it is weighed against.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "problems/chain/front/measure.hpp"
#include "problems/chain/topology.hpp"
#include "problems/linkage/linkage_limits.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {

/// What of a problem decides which objectives it can have.
struct FrontScope {
  const std::string& mechanism;  ///< `mechanism.type`
  const std::vector<Topology>& topologies;
  std::string_view of_any_count{"any"};  ///< a type with chains of several numbers of links
  bool has_sizes = true;                 ///< whether lengths are lengths, not ratios to one of them
  bool is_given = false;                 ///< whether all dimensions are
  std::string_view refusal{};  ///< why it has no front, "is given with …"; empty where it has
};

/// What the error is weighed against; empty where the error alone counts, or with a fault. With a
/// front, `solve.designs` is 12 by default.
std::optional<ChainMeasure> read_against(TableReader& solve_table, const FrontScope& scope,
                                         Solve& solve);

}  // namespace cognate::problems::reading
