/// @file Numbers that need a name only once.
#pragma once

#include <limits>
#include <numbers>

namespace cognate {

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kTurn = 2 * kPi;  ///< a whole turn in radians
inline constexpr double kRightAngle = kPi / 2;
inline constexpr double kDegree = kPi / 180;           ///< a degree in radians
inline constexpr double kDegreesInRadian = 180 / kPi;  ///< a radian in degrees
inline constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

}  // namespace cognate
