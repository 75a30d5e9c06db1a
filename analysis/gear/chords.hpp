/// @file Curves of outlines by chords.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "analysis/gear/tooth_outline.hpp"
#include "analysis/numbers/vec2.hpp"

namespace cognate::gear {

inline constexpr int kMostChords = 1024;

inline double distance_from_line(const Vec2d& point, const Vec2d& from, const Vec2d& to) {
  const double length = norm(to - from);
  return length > 0 ? std::abs(cross(to - from, point - from)) / length : norm(point - from);
}

/// How many equal steps of the parameter keep the middle of each from its chord by no more than
/// `tolerance`; a power of two.
template <class Curve>
int chords_for(const Curve& curve, double from, double to, double tolerance) {
  for (int chords = 1; chords < kMostChords; chords *= 2) {
    const double step = (to - from) / chords;
    double worst = 0;
    for (int i = 0; i < chords; ++i) {
      const double start = from + i * step;
      worst = std::max(
          worst, distance_from_line(curve(start + 0.5 * step), curve(start), curve(start + step)));
    }
    // The curve is farthest from the chord near the middle, not quite there.
    if (worst <= 0.9 * tolerance) return chords;
  }
  return kMostChords;
}

/// Appends the curve from after `from` to `to`.
template <class Curve>
void append_curve(std::vector<OutlinePoint>& points, OutlinePart part, const Curve& curve,
                  double from, double to, double tolerance) {
  const int chords = chords_for(curve, from, to, tolerance);
  for (int i = 1; i < chords; ++i) {
    points.push_back({curve(from + (to - from) * i / chords), part});
  }
  points.push_back({curve(to), part});
}

}  // namespace cognate::gear
