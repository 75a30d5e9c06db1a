/// @file How much of what can be found a multi-start search has seen.
#pragma once

#include <algorithm>
#include <cstddef>

namespace cognate::synthesis {

/// Estimated probability that a minimum as good as some that were seen was missed: that a start
/// which leads to a minimum so good leads to one that was not seen. (n₁ + 1)/(n + 1), where of n
/// such starts n₁ led to a minimum that no other led to. n₁/n is the estimate of Good (1953, "The
/// population frequencies of species and the estimation of population parameters", Biometrika 40,
/// eq. 9); one more start counts as such, so that the probability is never 0. Starts that lead to
/// worse minima are left out: however many there are, they say nothing of the good ones.
inline double unseen_probability(std::ptrdiff_t seen_once, std::ptrdiff_t starts) {
  return std::min(1.0, double(seen_once + 1) / double(starts + 1));
}

/// How many of the best minima say how well the best is known, where there are many others.
inline constexpr std::size_t kBestMinima = 10;

/// What a result says of its search.
struct SearchStatistics {
  int starts = 0;
  int best_hits = 0;  ///< how many of them led to the best minimum
  double unseen = 1;  ///< see `unseen_probability`; with limits, of a minimum within them
};

}  // namespace cognate::synthesis
