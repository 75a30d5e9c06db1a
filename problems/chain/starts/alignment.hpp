/// @file The distance of a drawn curve from the target once it is moved, turned and enlarged,
/// without any iteration: both are compared at equal arcs (with prescribed timing at the same
/// angles of the crank), for every place where the target may begin.
#pragma once

#include <vector>

#include "problems/chain/scaled.hpp"
#include "problems/chain/starts/draw.hpp"

namespace cognate::problems {

/// Where a drawn chain is to go. With e^{iθ} of its crank: p → move + turn·p.
struct Alignment {
  double error = 0;  ///< root mean square, in the target's unit
  Vec2d turn{1, 0};  ///< a complex number: turns and enlarges
  Vec2d move;
  /// Of the crank at each target, before it is turned, in order; timed: the phase alone.
  std::vector<double> angles;
};

/// A target, prepared.
class AlignmentTarget {
 public:
  explicit AlignmentTarget(const ScaledChain& problem);

  Alignment align(const DrawnCurve& curve) const;

 private:
  Alignment align_timed(const DrawnCurve& curve) const;
  Alignment align_arcs(const DrawnCurve& curve) const;

  const ScaledChain& problem_;
  std::vector<Vec2d> stations_;  ///< of the target: at equal arcs, or those timed
  std::vector<double> turns_;    ///< timed: crank angles of the stations
  std::vector<double> shares_;   ///< of the arc at which each target point is
};

/// `drawn` where `alignment` puts it.
synthesis::ChainDesign aligned(const ScaledChain& problem, const DrawnChain& drawn,
                               const Alignment& alignment);

}  // namespace cognate::problems
