/// @file Dyads that guide a body through four poses: Burmester's centre-point and circle-point
/// curves.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "synthesis/exact/motion/dyad.hpp"

namespace cognate::synthesis {

/// The dyads through four poses form a curve; their fixed pivots lie on the centre-point curve,
/// their moving pivots on the circle-point curve, both circular cubics that may fall apart into
/// lines and circles or hyperbolas.
///
/// A branch is a closed curve with a parameter in [0, 1), smooth and periodic, through infinity
/// where the curve is unbounded; there the dyad is pr or rp. There are one or two branches, more
/// where the cubic falls apart.
class BurmesterCurves {
 public:
  /// The curves of four poses, which are copied.
  explicit BurmesterCurves(std::span<const Pose, 4> poses);

  /// `family`: a curve to walk on. Else what is degenerate, and there are no branches.
  GuidanceStatus status() const { return status_; }
  int branch_count() const;

  /// The dyad at a parameter of a branch, exact to rounding. None where a whole line of partners
  /// belongs to one pivot (`family`), or where both pivots go to infinity (`none`).
  DyadSolutions at(int branch, double parameter) const;

  /// Points of a branch in order, so close that fixed as well as moving pivots follow one another
  /// within `spacing` × the extent of the poses as long as they are within `reach` × that extent of
  /// the poses; at most `limit` of them.
  struct Point {
    double parameter = 0;
    GuidingDyad dyad;
  };
  std::vector<Point> trace(int branch, double spacing, double reach, int limit = 20000) const;

  /// The dyads with a slider on the frame, or a block on the body: where the curves go to infinity.
  DyadSolutions sliders() const;
  DyadSolutions blocks() const;

  /// The dyads whose fixed pivots lie on a line of the frame (at most three), and those whose
  /// moving pivots lie on a line of the body (body axes).
  DyadSolutions with_fixed_pivot_on(const Line& line) const;
  DyadSolutions with_moving_pivot_on(const Line& line) const;

  /// For poses in translation or turned about one point: what guides them (see GuidanceStatus).
  DyadSolutions examples() const;

 private:
  struct Window {
    Vec2d centre;
    double extent = 0;
  };
  Window window() const;

  struct Data;
  std::shared_ptr<const Data> data_;
  GuidanceStatus status_ = GuidanceStatus::family;
};

}  // namespace cognate::synthesis
