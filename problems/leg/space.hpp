/// @file Which dimensions of a leg are sought, and within what.
#pragma once

#include <optional>
#include <vector>

#include "problems/chain/space.hpp"
#include "problems/leg/problem.hpp"

namespace cognate::problems {

/// What a search may miss its limits by: of a cosine, a length in units of the stride, a speed.
inline constexpr double kLegMargin = 3e-5;

/// Limits of the distance of the points of two lines, the same at every angle of the crank.
struct DistanceLimit {
  int from = 0, to = 0;
  double least = 0, most = 0;
};

/// The problem of one topology. The unit is the stride; the crank's pivot is the origin where the
/// file leaves it open, since moving a leg changes nothing.
struct LegSpace : ChainSpace {
  TargetScale scale;
  int foot;                                      ///< its line
  std::optional<double> height_min, height_max;  ///< in the unit, without the margin
  std::optional<synthesis::ChainDesign> known;   ///< published dimensions with what is given
  std::vector<DistanceLimit> distances;          ///< of `LegProblem::near`
  /// Whether no dimension is given or bounded, so that a leg drawn may be turned and enlarged about
  /// the crank's pivot.
  bool is_movable;
  const LegProblem* problem;

  LegSpace(const LegProblem& problem, const Topology& topology);

 private:
  LegSpace(const LegProblem& problem, const Topology& topology, const Topology& framed);
  void stay_near();
  void limit_distances(const synthesis::ChainDesign& published, double factor);
};

}  // namespace cognate::problems
