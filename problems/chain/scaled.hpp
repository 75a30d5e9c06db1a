/// @file The path problem of one topology in units of the target.
#pragma once

#include <span>
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

/// The directions that the body of the traced point is to have at the targets.
struct WantedHeadings {
  int line = -1;                  ///< of the heading
  std::vector<Vec2d> directions;  ///< unit vectors; empty where the path alone counts
  double weight = 0;              ///< the length, in the unit of the search, that a radian counts
};

/// The problem of one topology: its centroid is the origin, its size the unit.
struct ScaledChain : ChainSpace {
  std::vector<Vec2d> points;
  std::vector<double> crank_angles;  ///< timed; else empty
  bool closed = false;
  bool is_movable = false;  ///< the target; its crank angles are free
  bool over_turn = true;    ///< limits hold over the turn of the crank
  WantedHeadings headings;

  ScaledChain(const ChainPathProblem& problem, const Topology& topology, const TargetScale& scale);

  bool timed() const { return !crank_angles.empty(); }
  bool is_motion() const { return !headings.directions.empty(); }

  /// The body of the traced point, an attached one, is to have these `angles` (radians) at the
  /// targets; a radian counts `weight` units. Adds a line for its heading, which the topology does
  /// not have: a body's angle in its link is no dimension of the mechanism.
  void add_headings(std::span<const double> angles, double weight);
};

}  // namespace cognate::problems
