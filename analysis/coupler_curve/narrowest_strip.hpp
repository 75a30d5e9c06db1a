/// @file The narrowest strip between parallel lines that holds a set of points.
#pragma once

#include <span>
#include <vector>

#include "analysis/numbers/vec2.hpp"

namespace cognate {

/// The narrowest strip that holds points, by its middle line and half its width.
struct NarrowestStrip {
  Vec2d through;
  Vec2d direction{1, 0};  ///< unit vector
  double half_width = 0;
};

/// Half the width across the unit `direction` of the strip that holds all `points`.
double half_width_across(std::span<const Vec2d> points, const Vec2d& direction);

/// Finds strips; keeps its room from one set of points to the next.
class StripFinder {
 public:
  /// The narrowest strip: one of its lines holds a side of the points' convex hull, the other the
  /// corner farthest from that (Houle & Toussaint 1988), by walking both round the hull. `points`
  /// are sorted here by x, then y; for points that are sorted already the time is linear. One point
  /// or none, or points that coincide, give a strip of width zero along x.
  NarrowestStrip operator()(std::span<Vec2d> points);

 private:
  void find_hull(std::span<const Vec2d> points);

  std::vector<Vec2d> hull_;  ///< counter-clockwise, without points inside its sides
};

}  // namespace cognate
