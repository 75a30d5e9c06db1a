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

/// The best minima that starts lead to, by cost, and how thorough the search was.
///
/// Starts are drawn in rounds. The rule: the best minimum has been come to from several starts, or
/// the points are met to rounding by as many designs as are kept; at most some thousand starts.
std::vector<PathFound> explore_paths(const PathProblem& scaled, const PathExploration& exploration,
                                     const Deadline& deadline, Work& work,
                                     SearchThoroughness& thoroughness);

}  // namespace cognate::problems
