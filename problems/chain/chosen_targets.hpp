/// @file Of a target with many points those that a search looks at.
#pragma once

#include <cstddef>
#include <vector>

#include "problems/chain/scaled.hpp"

namespace cognate::problems {

struct ChosenTargets {
  std::vector<std::size_t> which;  ///< in order, evenly spread; at most `most`

  ChosenTargets(const ScaledChain& problem, std::size_t most);

  /// Of the crank angles at all points those at the chosen ones; of a timed path the phase as it
  /// is.
  std::vector<double> chosen(const ScaledChain& problem, const std::vector<double>& angles) const;

  /// Crank angles at all points from those at the chosen ones; of a timed path the phase as it is.
  std::vector<double> at_all(const ScaledChain& problem, const std::vector<double>& angles) const;
};

}  // namespace cognate::problems
