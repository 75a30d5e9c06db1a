/// @file How far convex polygons are from each other.
#pragma once

#include <span>

#include "analysis/numbers/vec2.hpp"

namespace cognate {

/// The shortest vector from a point of `a` to one of `b`, convex polygons with counter-clockwise
/// corners, of which a point and a line are the least; zero where they overlap. Neither is empty.
Vec2d hull_gap(std::span<const Vec2d> a, std::span<const Vec2d> b);

/// Its length; infinite where one is empty.
double hull_distance(std::span<const Vec2d> a, std::span<const Vec2d> b);

}  // namespace cognate
