/// @file How much of what can be found a multi-start search has seen.
#pragma once

#include <algorithm>
#include <cstddef>

namespace cognate::synthesis {

/// Estimated probability that one more start would lead to a minimum that was not seen, among those
/// as good as the ones that were kept: (n₁ + 1)/(n + 1), where n₁ of n starts led to a minimum that
/// no other led to. n₁/n is the estimate of Good (1953, "The population frequencies of species and
/// the estimation of population parameters", Biometrika 40, eq. 9); one more start counts as such,
/// so that the probability is never 0. A better minimum than the best is one of those not seen.
inline double unseen_probability(std::ptrdiff_t seen_once, int starts) {
  return std::min(1.0, double(seen_once + 1) / (starts + 1));
}

/// What a result says of its search.
struct SearchStatistics {
  int starts = 0;
  int best_hits = 0;  ///< how many of them led to the best minimum
  double unseen = 1;  ///< see `unseen_probability`; with limits, of a minimum within them
};

}  // namespace cognate::synthesis
