/// @file The search for the dimensions of a chain: designs drawn at random, aligned with the
/// target, fitted in lanes, and the best refined within their limits.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "problems/chain/scaled.hpp"
#include "problems/linkage/error_limit.hpp"
#include "problems/linkage/result.hpp"
#include "synthesis/search/multi_start.hpp"

namespace cognate::problems {

/// A minimum of one topology, in units of the target.
struct ChainMinimum {
  const ScaledChain* problem = nullptr;
  synthesis::ChainDesign design;
  std::vector<double> angles;  ///< of the crank at the targets, radians
  double rms = 0;              ///< distance from the targets, root mean square
  double stray = 0;            ///< between the targets, root mean square; see `squared_stray`

  /// By what designs are ordered: the worse of both. Those that meet the targets come first, by
  /// their stray.
  std::pair<double, double> rank() const {
    return {rms <= kMetError ? 0 : std::max(rms, stray), stray};
  }
};

struct ChainSearchResult {
  std::vector<ChainMinimum> designs;  ///< best first
  synthesis::SearchStatistics statistics;
};

/// Designs for `problems`, the same target with different topologies, which are searched in turns;
/// those that stay far behind the best are given up. `known`: designs of these problems from which
/// the search begins too.
ChainSearchResult search_chains(const std::vector<ScaledChain>& problems, const Solve& options,
                                const Run& run, const Deadline& deadline, Work& work,
                                const std::vector<ChainMinimum>& known = {});

}  // namespace cognate::problems
