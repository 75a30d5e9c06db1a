/// @file The order of the dimensions of a motion model, and its points.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "analysis/numbers/vec2.hpp"

namespace cognate::problems::motion_dimensions {

/// Where the dimensions of the two dyads begin; a point is two of them.
inline constexpr int kMoving1 = 0, kFixed1 = 2, kLength1 = 4, kSecond = 5;
inline constexpr int kMoving2 = kSecond, kFixed2 = kSecond + 2, kLength2 = kSecond + 4;

template <std::size_t Count>
Vec2d point(const std::array<double, Count>& v, int dimension) {
  const auto at = static_cast<std::size_t>(dimension);
  return {v[at], v[at + 1]};
}

}  // namespace cognate::problems::motion_dimensions
