/// @file A chain refined on all targets, its transmission angles held to their limit at every
/// position of the crank.
#pragma once

#include "problems/chain/scaled.hpp"
#include "synthesis/optimise/solver.hpp"

namespace cognate::problems {

struct RefinedChain {
  synthesis::ChainDesign design;
  std::vector<double> angles;  ///< as the start has them
  TargetPlace at;              ///< of the target
  double objective = 0;        ///< mean squared distance; infinite where there is no design
  double violation = 0;        ///< of the limits, as a cosine
  std::uint64_t evaluations = 0, gradients = 0;
  int iterations = 0;
};

/// Refines a design. A limit over a turn is semi-infinite (Hettich & Kortanek 1993, "Semi-infinite
/// programming"): it is asked where the cosines are extreme, and again where a solution exceeds it
/// elsewhere.
RefinedChain refine(const ScaledChain& problem, const synthesis::ChainDesign& design,
                    const std::vector<double>& angles, synthesis::Solver solver,
                    const synthesis::Options& options, const TargetPlace& at = {});

}  // namespace cognate::problems
