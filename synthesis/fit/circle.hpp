/// @file The circle nearest to points, algebraically.
#pragma once

#include <optional>
#include <span>

#include "analysis/numbers/vec2.hpp"

namespace cognate::synthesis {

struct Circle {
  Vec2d centre;
  double radius = 0;
};

/// The circle of least Σ (|z − c|² − r²)², a linear problem (Kåsa 1976, "A circle fitting procedure
/// and its error analysis"): exact where the points lie on a circle, and a start for the distances
/// where they do not. Empty for fewer than three points and for points on a line.
std::optional<Circle> algebraic_circle(std::span<const Vec2d> points);

}  // namespace cognate::synthesis
