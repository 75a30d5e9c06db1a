/// @file Where a curve comes that may be moved, turned and enlarged.
#pragma once

#include <cmath>

#include "analysis/numbers/vec2.hpp"

namespace cognate::problems {

/// p → shift + scale·R(turn) p, without mirroring.
struct CurvePlacement {
  double scale = 1;
  double turn = 0;  ///< radians, counter-clockwise
  Vec2d shift;

  Vec2d point(const Vec2d& p) const { return shift + vector(p); }
  Vec2d vector(const Vec2d& v) const { return scale * (direction() * v); }
  Vec2d point_back(const Vec2d& p) const { return (1 / scale) * (conj(direction()) * (p - shift)); }

 private:
  Vec2d direction() const { return {std::cos(turn), std::sin(turn)}; }
};

}  // namespace cognate::problems
