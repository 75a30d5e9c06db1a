/// @file Which numbers a cam's file takes.
#pragma once

#include "analysis/numbers/constants.hpp"
#include "problems/mechanism/quantity_rules.hpp"

namespace cognate::problems::reading {

/// Of a segment: so many that the rest of a turn has room, so large that its jerk is finite.
inline constexpr NumberRule kCamAngle{[](double x) { return x >= 1e-6 && x <= 360; },
                                      "an angle in degrees from 1e-6 to 360"};

inline constexpr NumberRule kPlaceInSegment{[](double x) { return x >= 0 && x <= 360; },
                                            "an angle in degrees from 0 to over_deg"};

inline constexpr NumberRule kSwingAngle{
    [](double x) { return x >= -180 && x <= 180 && is_quantity(x); },
    "an angle in degrees from -180 to 180"};

inline constexpr NumberRule kAccelerationShare{
    [](double x) { return x == 0 || (x >= 1e-12 && x <= 1); }, "a share from 0 to 1"};

inline constexpr NumberRule kPressureLimit{[](double x) { return x >= 1e-3 && x <= 89.999; },
                                           "an angle in degrees from 0.001 to 89.999"};

inline constexpr NumberRule kArmsAngle{[](double x) { return x >= 1e-3 && x <= 359.999; },
                                       "an angle in degrees from 0.001 to 359.999"};

inline constexpr NumberRule kRadiusOrNone{[](double x) { return x >= 0 && is_quantity(x); },
                                          "0 or a length from 1e-30 to 1e30"};

inline constexpr NumberRule kPositive{is_positive_quantity, "a number from 1e-30 to 1e30"};

inline constexpr NumberRule kTurningSpeed{is_positive_quantity,
                                          "a speed in rad/s from 1e-30 to 1e30"};

inline constexpr NumberRule kPoisson{[](double x) { return x >= 0 && x <= 0.5 && is_quantity(x); },
                                     "a ratio from 0 to 0.5"};

/// Ends of ranges; inf leaves them open.
inline constexpr NumberRule kCamLengthLimit{
    [](double x) { return x >= 0 && (is_quantity(x) || x == kInfinity); },
    "0, a length from 1e-30 to 1e30 or inf"};

inline constexpr NumberRule kCamPlaceLimit{
    [](double x) { return is_quantity(x) || x == kInfinity || x == -kInfinity; },
    "a number, 0, of magnitude 1e-30 to 1e30 or infinite,"};

}  // namespace cognate::problems::reading
