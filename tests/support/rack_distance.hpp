/// @file The rack that cuts a gear as a solid, and how far points of the gear stay from it while it
/// rolls: an oracle for outlines that knows nothing of involutes and trochoids.
#pragma once

#include <cmath>

#include "analysis/gear/spur_gear.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/golden_section.hpp"
#include "analysis/numbers/vec2.hpp"

namespace cognate::test {

/// Signed distance, negative inside, of a point from a tooth of the rack that points down, endless
/// upwards: `point` relative to the tooth's middle on the datum line, in modules. The solid is a
/// trapezoid grown by the radius of the tip's corners.
inline double distance_from_tooth(const gear::SpurGear& g, const Vec2d& point) {
  const double alpha = g.rack.pressure_angle;
  const double rounding = g.rack.corner_radius.value_or(g.rack.clearance / (1 - std::sin(alpha)));
  const double half_width = kPi / 4 + g.coarsening / (2 * g.module);
  const Vec2d normal{std::cos(alpha), -std::sin(alpha)};
  // The corner's centre is its radius from the tip line and from the flank.
  const double height = rounding - g.rack.addendum - g.rack.clearance;
  const Vec2d corner{half_width + (height * std::sin(alpha) - rounding) / std::cos(alpha), height};
  const Vec2d to_point = Vec2d{std::abs(point.x), point.y} - corner;
  const double from_flank = dot(to_point, normal);
  const bool beyond_tip = to_point.x > 0 && dot(to_point, {std::sin(alpha), std::cos(alpha)}) < 0;
  return (beyond_tip ? norm(to_point) : std::max(from_flank, -to_point.y)) - rounding;
}

/// The distance of `point`, of a gear whose first tooth's middle is the y axis, from the rack's
/// tooth in the space to the left of that tooth, when the gear has turned by `angle`. In modules.
inline double distance_at(const gear::SpurGear& g, const Vec2d& point, double angle) {
  const double r = 0.5 * g.teeth;
  const Vec2d turned = Vec2d{std::cos(angle), std::sin(angle)} * ((1 / g.module) * point);
  const Vec2d tooth{-0.5 * kPi - r * angle, r + g.profile_shift};
  return distance_from_tooth(g, turned - tooth);
}

struct Closest {
  double distance = 0;  ///< negative: the rack cuts the point away
  double angle = 0;     ///< of the gear, then
};

/// The least distance over all positions from which the rack reaches the point.
inline Closest closest(const gear::SpurGear& g, const Vec2d& point) {
  constexpr int kSteps = 300;
  const double middle = -kPi / g.teeth;  // there the rack's tooth is upright in the space
  const double range = 12 / g.teeth + 0.4;
  const auto distance = [&](double angle) { return distance_at(g, point, angle); };
  Closest best{distance(middle), middle};
  for (int i = -kSteps; i <= kSteps; ++i) {
    const double angle = middle + range * i / kSteps;
    if (const double d = distance(angle); d < best.distance) best = {d, angle};
  }
  const double step = range / kSteps;
  const auto refined = golden_section(distance, best.angle - step, best.angle + step, 50);
  return {refined.least(), refined.middle()};
}

}  // namespace cognate::test
