/// @file The first stage of a path search: many screened starts, each brought near its minimum in
/// SIMD lanes.
#pragma once

#include <optional>
#include <vector>

#include "problems/path/found.hpp"

namespace cognate::problems {

/// How an exploration ends: after a number of starts that the file gives, or by a rule.
struct PathExploration {
  std::optional<int> starts;  ///< empty: until the rule says that more would find nothing new
  std::size_t kept = 0;       ///< how many minima go on
  Run run;
};

struct ExploredPaths {
  std::vector<PathFound> minima;  ///< the best, by cost
  int starts = 0;
};

/// The best minima that starts lead to, and how many starts there were.
///
/// Starts are drawn in rounds; from the second round on half of those of points that are not timed
/// meet them about when the best minima so far do, of all valleys, and half of these are linkages
/// like those. The rule: the best minimum was found in the first third of the starts, several
/// independent ones lead to it and few minima as good were seen but once, or the points are met to
/// rounding by as many designs as are kept; at most some thousand starts.
ExploredPaths explore_paths(const PathProblem& scaled, const PathExploration& exploration,
                            const Deadline& deadline, Work& work);

}  // namespace cognate::problems
