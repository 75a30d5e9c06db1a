/// @file A chain whose dimensions are fixed against a target that may be moved.
#pragma once

#include <limits>
#include <vector>

#include "problems/chain/scaled.hpp"

namespace cognate::problems {

/// A chain, where its target is, and where its crank is at each point of that.
struct PlacedChain {
  synthesis::ChainDesign design;
  std::vector<double> angles;
  TargetPlace at;
  double objective = std::numeric_limits<double>::infinity();  ///< mean squared distance
};

/// Moves the target and the crank, the dimensions staying, by Gauss–Newton steps: each point counts
/// by its distance along the path's normal, so that four unknowns remain, and the crank follows.
/// The objective is that of the place reached; infinite where the chain is not assembled at a
/// point or a joint there exceeds its limit.
void fit_place(const ScaledChain& problem, PlacedChain& chain);

}  // namespace cognate::problems
