/// @file Which numbers a key takes, and how a message says so.
#pragma once

#include <cmath>
#include <string_view>

#include "analysis/numbers/constants.hpp"

namespace cognate::problems::reading {

/// A test, and what it accepts in words: "… is -1; expected a length from 1e-100 to 1e100".
struct NumberRule {
  bool (*accepts)(double);
  std::string_view allowed;
};

/// The magnitudes that can be squared and divided with room to spare in a double.
inline constexpr double kLeastMagnitude = 1e-100;
inline constexpr double kGreatestMagnitude = 1e100;

constexpr bool is_positive_magnitude(double x) {
  return x >= kLeastMagnitude && x <= kGreatestMagnitude;
}

constexpr bool is_magnitude(double x) {
  return x == 0 || is_positive_magnitude(x < 0 ? -x : x);
}

inline constexpr NumberRule kNumber{is_magnitude, "a number, 0 or of magnitude 1e-100 to 1e100"};

inline constexpr NumberRule kLength{is_positive_magnitude, "a length from 1e-100 to 1e100"};

/// An end of a range of lengths; inf leaves it open.
inline constexpr NumberRule kLengthLimit{
    [](double x) { return x >= 0 && (is_magnitude(x) || x == kInfinity); },
    "0, a length from 1e-100 to 1e100 or inf"};

/// An end of a range of coordinates; inf leaves it open.
inline constexpr NumberRule kCoordinateLimit{
    [](double x) { return is_magnitude(x) || x == kInfinity || x == -kInfinity; },
    "a number, 0, of magnitude 1e-100 to 1e100 or infinite,"};

/// Degrees; so many turns that nothing meaningful is beyond, so few that no digits are lost.
inline constexpr NumberRule kAngle{[](double x) { return x >= -36000 && x <= 36000; },
                                   "an angle in degrees from -36000 to 36000"};

inline constexpr NumberRule kSweep{
    [](double x) { return x != 0 && is_magnitude(x) && x >= -360 && x <= 360; },
    "an angle in degrees from -360 to 360 other than 0"};

/// How far a slider moves, against its direction where negative.
inline constexpr NumberRule kTravel{[](double x) { return x != 0 && is_magnitude(x); },
                                    "a displacement of magnitude 1e-100 to 1e100"};

inline constexpr NumberRule kMultiplicity{
    [](double x) { return x == 1 || x == 2 || x == 3 || x == 4 || x == 5; },
    "an integer from 1 to 5"};

inline constexpr NumberRule kTransmissionAngle{[](double x) { return x >= 0 && x <= 180; },
                                               "an angle in degrees from 0 to 180"};

inline constexpr NumberRule kWeight{[](double x) { return x >= 0 && is_magnitude(x); },
                                    "a weight, 0 or from 1e-100 to 1e100"};

inline constexpr NumberRule kRatio{[](double x) { return x >= 1 && x <= kGreatestMagnitude; },
                                   "a ratio from 1 to 1e100"};

inline constexpr NumberRule kDutyFactor{[](double x) { return x >= 0.05 && x <= 0.95; },
                                        "a share of the turn from 0.05 to 0.95"};

inline constexpr NumberRule kErrorScale{is_positive_magnitude, "an error from 1e-100 to 1e100"};

inline constexpr NumberRule kTolerance{[](double x) { return x > 0 && x < 1; },
                                       "a number above 0 and below 1"};

/// Degrees to radians.
constexpr double radians(double degrees) {
  return degrees * (kPi / 180.0);
}

}  // namespace cognate::problems::reading
