/// @file Every choice of teeth and module that a file leaves, sieved by cheap tests.
#pragma once

#include <cstdint>
#include <vector>

#include "problems/deadline.hpp"
#include "problems/gear/gear_pair_search.hpp"

namespace cognate::problems {

/// What is left of all combinations, and how many each test refused.
struct Sieved {
  std::vector<GearCombination> left;
  /// Of those refused the ones that got farthest, nearest to passing first: where nothing is left
  /// they show what is missing.
  std::vector<GearCombination> nearest;
  std::uint64_t tested = 0;
  std::uint64_t refused_by_ratio = 0, refused_by_hunting = 0, refused_by_centre_distance = 0,
                refused_by_undercut = 0;
};

/// In the order of teeth and modules; stops at the deadline.
Sieved sieve(const GearPairProblem& problem, const Deadline& deadline);

}  // namespace cognate::problems
