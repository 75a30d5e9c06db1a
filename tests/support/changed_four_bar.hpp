/// @file The path of a four-bar whose dimensions are changed, by triangles that share nothing with
/// the project's own.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "analysis/linkage/four_bar.hpp"

namespace cognate::test {

/// Where the body of the coupler stands: its coupler point, and the angle of the coupler.
struct ChangedBody {
  Vec2d at;
  double angle = 0;
};

/// The body with every length changed by `changes`: crank, coupler, rocker, frame, u, v. Not a
/// number where the linkage cannot be assembled.
inline ChangedBody changed_body(const FourBar& bar, const std::vector<double>& changes,
                                double angle) {
  const Vec2d way = bar.pivot_d - bar.pivot_a;
  const double frame = std::hypot(way.x, way.y);
  const Vec2d d = bar.pivot_a + ((frame + changes[3]) / frame) * way;
  const double crank = bar.crank + changes[0], coupler = bar.coupler + changes[1];
  const double rocker = bar.rocker + changes[2];
  const Vec2d b = bar.pivot_a + crank * Vec2d{std::cos(angle), std::sin(angle)};
  const double diagonal = std::hypot(d.x - b.x, d.y - b.y);
  const double at_b = std::acos((coupler * coupler + diagonal * diagonal - rocker * rocker) /
                                (2 * coupler * diagonal));
  const double to =
      std::atan2(d.y - b.y, d.x - b.x) + (bar.assembly == Assembly::open ? at_b : -at_b);
  return {
      b + Vec2d{std::cos(to), std::sin(to)} * (*bar.coupler_point + Vec2d{changes[4], changes[5]}),
      to};
}

/// The coupler point of that body.
inline Vec2d changed_point(const FourBar& bar, const std::vector<double>& changes, double angle) {
  return changed_body(bar, changes, angle).at;
}

/// The greatest distance of the changed linkage's path from the targets, at these crank angles; or,
/// where the crank follows, at the nearest angle within `reach` of them. Infinite where it cannot
/// be assembled at one.
inline double changed_path_error(const FourBar& bar, const std::vector<double>& changes,
                                 const std::vector<double>& angles,
                                 const std::vector<Vec2d>& targets, double reach) {
  double greatest = 0;
  for (std::size_t j = 0; j < targets.size(); ++j) {
    const auto from = [&](double angle) {
      const Vec2d off = changed_point(bar, changes, angle) - targets[j];
      return std::hypot(off.x, off.y);
    };
    double low = angles[j] - reach, high = angles[j] + reach;
    for (int i = 0; reach > 0 && i < 40; ++i) {
      const double one = low + 0.381966 * (high - low), two = high - 0.381966 * (high - low);
      (from(one) < from(two) ? high : low) = from(one) < from(two) ? two : one;
    }
    const double error = from(0.5 * (low + high));
    if (!(error <= greatest)) greatest = error;
  }
  return std::isnan(greatest) ? std::numeric_limits<double>::infinity() : greatest;
}

}  // namespace cognate::test
