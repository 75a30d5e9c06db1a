/// @file How far convex polygons are from each other.
#pragma once

#include <span>

#include "analysis/numbers/vec2.hpp"

namespace cognate::app {

/// The distance of two convex polygons with counter-clockwise corners, of which a point and a line
/// are the least; 0 where they overlap.
double hull_distance(std::span<const Vec2d> a, std::span<const Vec2d> b);

}  // namespace cognate::app
