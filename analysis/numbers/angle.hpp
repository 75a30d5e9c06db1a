/// @file Angles and the directions they stand for.
#pragma once

#include <cmath>

#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/vec2.hpp"

namespace cognate {

/// `angle` less whole turns, in [0, 2π).
inline double in_one_turn(double angle) {
  const double reduced = std::remainder(angle, kTurn);
  const double positive = reduced < 0 ? reduced + kTurn : reduced;
  return positive < kTurn ? positive : 0;  // a tiny negative angle rounds up to the whole turn
}

/// The unit vector at `angle` from the x axis.
inline Vec2d unit_vector(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

/// The angle of `v` from the x axis, in [−π, π].
inline double angle_of(const Vec2d& v) {
  return std::atan2(v.y, v.x);
}

}  // namespace cognate
