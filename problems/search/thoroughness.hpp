/// @file How much of what can be found a search has seen.
#pragma once

#include <cstddef>
#include <vector>

#include "problems/basics/fact.hpp"

namespace cognate::problems {

/// Chance that one more start would lead to a minimum that was not seen, among those as good as the
/// ones that were kept: the share of starts whose minimum was seen once (Good 1953, "The population
/// frequencies of species and the estimation of population parameters"). One more of them counts as
/// seen once, so that the chance is never none. With limits the minima are those within them.
inline double chance_of_unseen(std::ptrdiff_t seen_once, int starts) {
  return double(seen_once + 1) / (starts + 1);
}

struct SearchThoroughness {
  int starts = 0;
  int best_hits = 0;  ///< how many of them led to the best minimum
  double unseen = 1;  ///< see `chance_of_unseen`

  /// What a result says of it.
  std::vector<Fact> facts() const {
    return {{"starts", double(starts)},
            {"best_hits", double(best_hits)},
            {"chance_of_unseen_minimum", unseen}};
  }
};

}  // namespace cognate::problems
