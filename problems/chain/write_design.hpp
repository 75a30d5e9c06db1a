/// @file A chain that is to be designed, written down as files say it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problems/chain/problem.hpp"
#include "problems/linkage/linkage_limits.hpp"
#include "problems/toml/table_writer.hpp"

namespace cognate::problems::reading {

/// `[mechanism]` of the type `type` with what is given.
TableWriter chain_mechanism_writer(const std::string& type,
                                   const std::vector<Topology>& topologies);

/// `[bounds]`, point by point.
TableWriter chain_bounds_writer(const std::vector<Topology>& topologies);

/// `[solve]`, with the objectives of a front. What of it the search has no use for is written for
/// the reader to refuse.
TableWriter chain_solve_writer(const Solve& solve, const std::optional<ChainMeasure>& against);

/// `target.timing` and `target.crank_deg` of the crank's `angles`, radians; empty: free.
void write_chain_timing(const std::vector<double>& angles, TableWriter& target);

/// `target.point` of a chain that the file defines.
void write_traced(const std::string& type, const std::vector<Topology>& topologies,
                  TableWriter& target);

/// `[constraints]` of paths and motions, but for layers.
TableWriter chain_constraints_writer(const ChainConstraints& constraints);

/// `problem`, with the topologies `known` of its type where it has none, as it is read from what is
/// written of it; or the faults that its reader finds.
template <class AnyProblem>
tl::expected<AnyProblem, std::vector<std::string>> checked_chain(
    const AnyProblem& problem, const std::vector<Topology>& known) {
  AnyProblem complete = problem;
  if (complete.topologies.empty()) complete.topologies = known;
  const auto read = read_back(complete);
  if (!read) return tl::unexpected(read.error());
  complete.topologies = read->topologies;
  return complete;
}

/// A fault where topologies demand different things of points of one name, which no file can.
void check_one_demand(const std::vector<Topology>& topologies, std::vector<std::string>& faults);

/// A fault where the topologies are not those that files know by the word `type`, which are
/// `known`.
void check_structure(const std::string& type, const std::vector<Topology>& topologies,
                     const std::vector<Topology>& known, std::vector<std::string>& faults);

}  // namespace cognate::problems::reading
