/// @file The convex hull of some points.
#pragma once

#include <vector>

#include "analysis/numbers/vec2.hpp"

namespace cognate {

/// Corners of the convex hull of `points`, counter-clockwise: two where they are collinear, one
/// where they coincide. Corners nearer than `tolerance` to the line through their neighbours are
/// left out. Andrew, Another efficient algorithm for convex hulls in two dimensions, 1979.
std::vector<Vec2d> convex_hull(std::vector<Vec2d> points, double tolerance);

}  // namespace cognate
