/// @file Angles from the tangents of their halves.
#pragma once

#include <algorithm>
#include <cmath>

namespace cognate {

/// The angle in [0, π] whose half has the tangent √(opposite/adjacent): with 1 − cos and 1 + cos of
/// an angle, in any common unit, that angle to full relative accuracy. Both are clipped at zero.
inline double angle_of_half(double opposite, double adjacent) {
  return 2 * std::atan2(std::sqrt(std::max(opposite, 0.0)), std::sqrt(std::max(adjacent, 0.0)));
}

}  // namespace cognate
