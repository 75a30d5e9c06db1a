/// @file A circle of the plane.
#pragma once

#include "analysis/numbers/vec2.hpp"

namespace cognate {

/// Centre and radius, in one unit.
struct Circle {
  Vec2d centre;
  double radius = 0;
};

}  // namespace cognate
