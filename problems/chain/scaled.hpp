/// @file The path problem of one topology in units of the target.
#pragma once

#include <vector>

#include "problems/chain/problem.hpp"
#include "problems/chain/space.hpp"

namespace cognate::problems {

/// Where a target lies that may be moved: the traced point p is compared with it at turn·p + shift.
struct TargetPlace {
  static constexpr std::size_t kNumbers = 4;

  Vec2d turn{1, 0};  ///< a complex number: turns and enlarges
  Vec2d shift;

  Vec2d point(const Vec2d& p) const { return turn * p + shift; }
};

/// The problem of one topology: its centroid is the origin, its size the unit.
struct ScaledChain : ChainSpace {
  std::vector<Vec2d> points;
  std::vector<double> crank_angles;  ///< timed; else empty
  bool closed = false;
  bool is_movable = false;  ///< the target; its crank angles are free
  bool over_turn = true;    ///< limits hold over the turn of the crank

  ScaledChain(const ChainPathProblem& problem, const Topology& topology, const TargetScale& scale);

  bool timed() const { return !crank_angles.empty(); }
};

}  // namespace cognate::problems
