/// @file Places on bodies, and of bodies.
#pragma once

#include "analysis/numbers/vec2.hpp"

namespace cognate {

/// A point fixed on a body, in the body's axes.
template <class T>
struct Attached {
  int body = 0;
  Vec2<T> at{};
};

/// Where a body's axes stand.
struct Placement {
  Vec2d origin{};
  Vec2d direction{1, 0};
};

}  // namespace cognate
