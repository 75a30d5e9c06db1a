/// @file Which constraints fight where no design meets all of them, and how far they must give way.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "synthesis/search/search.hpp"

namespace cognate::synthesis {

/// Constraints that make a design possible when they give way together, each by `share` of the way
/// from its limit (0) to no limit (1).
struct Concession {
  std::vector<std::size_t> constraints;
  double share = 1;
};

/// What stands in the way of a design.
struct Infeasibility {
  /// What was found out.
  enum class Finding {
    unknown,   ///< nothing helps, there are no constraints, or time is up
    feasible,  ///< a design meets all of them after all
    any_of,    ///< each of `ways` alone is enough
    together   ///< the one of `ways`, of as few constraints as were found, is enough
  };
  Finding finding = Finding::unknown;
  std::vector<Concession> ways;
};

/// Whether a design is found when each constraint has given way by its share.
using RelaxedFeasibility = std::function<bool(std::span<const double> shares)>;

/// The constraints each of which stands alone in the way, with the least share that is enough, to
/// 1/128; else the fewest that must give way together. `by_degrees`: one entry for each constraint,
/// 0 where it can only be given up. It calls `feasible` some dozen times, first without any change,
/// and is as sure as its answers; unknown where `is_over`, which is asked before each call.
Infeasibility explain_infeasibility(std::span<const char> by_degrees,
                                    const RelaxedFeasibility& feasible,
                                    const std::function<bool()>& is_over);

/// By how much a scaled constraint may miss, c ≥ −slack, at a share: 0 … ∞.
double slack_at(double share);

/// That of a model: which of its inequalities stand in the way, by their number behind the
/// equalities, and the share of which `slack_at` says by how much they must give way.
Infeasibility explain_infeasibility(const Model& model, const SearchOptions& options = {});

}  // namespace cognate::synthesis
