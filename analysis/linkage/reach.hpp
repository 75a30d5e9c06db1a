/// @file Whether links reach, where rounding decides.
#pragma once

#include <algorithm>
#include <cmath>

#include "analysis/numbers/constants.hpp"

namespace cognate {

/// What rounding leaves of a difference of lengths of order one that is zero.
inline constexpr double kReachRounding = 16 * kEpsilon;

/// Whether a difference of lengths of order one is negative only by rounding, if at all.
inline bool suffices(double room) {
  return room >= -kReachRounding;
}

/// √(a b) of factors that rounding may have left just below zero.
inline double root(double a, double b) {
  return std::sqrt(std::max(a, 0.0)) * std::sqrt(std::max(b, 0.0));
}

}  // namespace cognate
