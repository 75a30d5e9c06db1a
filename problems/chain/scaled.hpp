/// @file The path problem of one topology in units of the target.
#pragma once

#include <vector>

#include "problems/chain/problem.hpp"
#include "problems/chain/space.hpp"

namespace cognate::problems {

/// The problem of one topology: its centroid is the origin, its size the unit.
struct ScaledChain : ChainSpace {
  std::vector<Vec2d> points;
  std::vector<double> crank_angles;  ///< timed; else empty
  bool closed = false;
  bool over_turn = true;  ///< limits hold over the turn of the crank

  ScaledChain(const ChainPathProblem& problem, const Topology& topology, const TargetScale& scale);

  bool timed() const { return !crank_angles.empty(); }
};

}  // namespace cognate::problems
