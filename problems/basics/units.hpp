/// @file Angles, speeds and bounds as people write them.
#pragma once

#include "analysis/numbers/constants.hpp"
#include "problems/basics/range.hpp"

namespace cognate {

/// `using namespace cognate::literals;` for `45_deg` and `1450_rpm`.
namespace literals {

/// Degrees, in radians: the same number that a file's reader makes of a key in `_deg`.
constexpr double operator""_deg(long double degrees) {
  return static_cast<double>(degrees) * (kPi / 180);
}
constexpr double operator""_deg(unsigned long long degrees) {
  return static_cast<double>(degrees) * (kPi / 180);
}

/// Turns in a minute, in rad/s.
constexpr double operator""_rpm(long double turns) {
  return static_cast<double>(turns) * (kTurn / 60);
}
constexpr double operator""_rpm(unsigned long long turns) {
  return static_cast<double>(turns) * (kTurn / 60);
}

}  // namespace literals

namespace problems {

/// Ranges that are open at one side or at none.
constexpr Range at_least(double min) {
  return {min, kInfinity};
}
constexpr Range at_most(double max) {
  return {-kInfinity, max};
}
constexpr Range between(double min, double max) {
  return {min, max};
}

/// The box whose sides are no farther than `reach` from `centre`.
constexpr Box around(const Vec2d& centre, double reach) {
  return {{centre.x - reach, centre.y - reach}, {centre.x + reach, centre.y + reach}};
}

/// The box from `min` to `max` in x and y.
constexpr Box box(const Range& x, const Range& y) {
  return {{x.min, y.min}, {x.max, y.max}};
}

}  // namespace problems
}  // namespace cognate
