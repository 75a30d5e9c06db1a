/// @file Every choice of teeth and module that a file leaves, sieved by cheap tests.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "problems/gear/pair_search.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// What is left of all combinations, and how many each test refused.
struct Sieved {
  std::vector<GearCombination> left;
  /// Of those refused the ones that got farthest, nearest to passing first: where nothing is left
  /// they show what is missing.
  std::vector<GearCombination> nearest;
  std::uint64_t all = 0;                   ///< that there are
  std::uint64_t tested = 0;                ///< of them, before the deadline
  std::array<std::uint64_t, 4> refused{};  ///< by each `CheapTest`
  std::uint64_t copies = 0;                ///< beside `all`: scaled copies of these
};

/// Whether pairs of the same teeth at another module are the same but for their size, so that the
/// smallest module is as good as any: nothing but the module is a length.
bool scales_with_module(const GearPairProblem& problem);

/// In an order that mixes teeth and modules, so that a run which is cut short has seen some of all
/// sizes; of modules that only scale the smallest. Stops at the deadline.
Sieved sieve(const GearPairProblem& problem, const Deadline& deadline);

}  // namespace cognate::problems
