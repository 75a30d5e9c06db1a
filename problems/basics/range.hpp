/// @file Intervals and rectangles.
#pragma once

#include "analysis/numbers/vec2.hpp"

namespace cognate::problems {

/// A closed interval; a side that is not limited is infinite.
struct Range {
  double min = 0;
  double max = 0;
};

/// An axis-parallel rectangle.
struct Box {
  Vec2d min;
  Vec2d max;
};

}  // namespace cognate::problems
