/// @file The piece of a line between two points.
#pragma once

#include <algorithm>

#include "analysis/numbers/vec2.hpp"

namespace cognate {

/// How far p is from the nearest point of the segment from a to b, which may be one point.
inline double distance_to_segment(const Vec2d& p, const Vec2d& a, const Vec2d& b) {
  const Vec2d way = b - a;
  const double square = squared_norm(way);
  const double share = square > 0 ? std::clamp(dot(p - a, way) / square, 0.0, 1.0) : 0;
  return norm(p - a - share * way);
}

}  // namespace cognate
