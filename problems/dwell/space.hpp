/// @file Which dimensions of a mechanism with dwells are sought, and within what.
#pragma once

#include <optional>

#include "problems/chain/output/space.hpp"
#include "problems/dwell/problem.hpp"

namespace cognate::problems {

/// The problem of one topology; of a slider in units of the space.
struct DwellSpace : OutputSpace {
  double swing_min;             ///< of the problem, with what a search may miss it by
  std::optional<double> apart;  ///< of the problem
  const DwellProblem* problem;

  DwellSpace(const DwellProblem& problem, const Topology& topology);
};

}  // namespace cognate::problems
