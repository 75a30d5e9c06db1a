/// @file Which bodies of a mechanism slide, along what, and which bodies turn.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "analysis/mechanism/mechanism.hpp"
#include "analysis/mechanism/motion_state.hpp"

namespace cognate {

/// Body `slider` slides along the line through `through` with the unit vector `direction`, both in
/// the axes of body `through.body`. Its displacement is that of its origin along the line from
/// `through`.
struct SlidingPair {
  int slider = 0;
  Attached<double> through;
  Vec2d direction{1, 0};
};

/// The pair of body `slider` and a guide.
SlidingPair on_guide(int slider, const Guide<double>& guide);

/// Every sliding pair, in the order of the bodies, but for that of a driving slider, whose
/// displacement is given.
std::vector<SlidingPair> sliding_pairs(const Mechanism<double>& mechanism);

/// For each body whether its angle changes: not that of the frame, nor of what slides on a body
/// whose angle does not.
std::vector<bool> turning_bodies(const Mechanism<double>& mechanism);

/// dᵏs/dqᵏ, k = 0…Order ≤ 2, of the displacement s of a slider along its line.
///
/// With r from `through` to the slider's origin and u the line's direction: s = r·u.
template <int Order>
std::array<double, Order + 1> displacement(const SlidingPair& pair,
                                           std::span<const BodyMotion<double, Order>> bodies) {
  const auto& guide = bodies[static_cast<std::size_t>(pair.through.body)];
  const auto& slider = bodies[static_cast<std::size_t>(pair.slider)];
  const auto through = point_motion<double, Order>(guide, pair.through.at);
  const Vec2d u = guide.direction * pair.direction;
  const Vec2d r = slider.origin[0] - through[0];
  std::array<double, Order + 1> s{};
  s[0] = dot(r, u);
  if constexpr (Order >= 1) {
    const Vec2d r1 = slider.origin[1] - through[1];
    const Vec2d u1 = guide.turn[0] * perp(u);
    s[1] = dot(r1, u) + dot(r, u1);
    if constexpr (Order >= 2) {
      const Vec2d r2 = slider.origin[2] - through[2];
      const Vec2d u2 = guide.turn[1] * perp(u) - (guide.turn[0] * guide.turn[0]) * u;
      s[2] = dot(r2, u) + 2 * dot(r1, u1) + dot(r, u2);
    }
  }
  return s;
}

}  // namespace cognate
