/// @file Which numbers a gear's file takes.
#pragma once

#include "analysis/numbers/constants.hpp"
#include "problems/gear/problem.hpp"
#include "problems/mechanism/quantity_rules.hpp"

namespace cognate::problems::reading {

inline constexpr std::string_view kTeethKey = "teeth", kModule = "module", kShift = "profile_shift",
                                  kDistance = "centre_distance", kReduction = "tip_reduction";

constexpr bool is_whole_number(double x) {
  return x == static_cast<double>(static_cast<int>(x));
}

inline constexpr NumberRule kTeeth{
    [](double x) { return x >= kFewestTeeth && x <= kMostTeeth && is_whole_number(x); },
    "a whole number from 3 to 2000"};

inline constexpr NumberRule kStarts{
    [](double x) { return x >= 1 && x <= 12 && is_whole_number(x); },
    "a whole number from 1 to 12"};

/// In modules; what is beyond is no tooth of any rack.
inline constexpr NumberRule kProfileShift{
    [](double x) { return x >= -10 && x <= 10 && is_quantity(x); }, "a number from -10 to 10"};

inline constexpr NumberRule kTipReduction{
    [](double x) { return x >= -1 && x <= 2 && is_quantity(x); }, "a number from -1 to 2"};

inline constexpr NumberRule kHelix{
    [](double x) { return x >= -80 && x <= 80 && (x >= 1e-3 || x <= -1e-3); },
    "an angle in degrees from 0.001 to 80, or from -80 to -0.001,"};

inline constexpr NumberRule kRackAngle{[](double x) { return x >= 5 && x <= 45; },
                                       "an angle in degrees from 5 to 45"};

inline constexpr NumberRule kRackAddendum{[](double x) { return x >= 0.1 && x <= 3; },
                                          "a number of modules from 0.1 to 3"};

inline constexpr NumberRule kRackClearance{[](double x) { return x >= 1e-3 && x <= 2; },
                                           "a number of modules from 0.001 to 2"};

inline constexpr NumberRule kRackTipRadius{[](double x) { return x >= 0 && x <= 3; },
                                           "a number of modules from 0 to 3"};

inline constexpr NumberRule kGearRatio{[](double x) { return x >= 1e-3 && x <= 1e3; },
                                       "a ratio from 0.001 to 1000"};

inline constexpr NumberRule kRelativeTolerance{[](double x) { return x >= 0 && x <= 1; },
                                               "a number from 0 to 1"};

inline constexpr NumberRule kContactRatio{[](double x) { return x >= 1 && x <= 100; },
                                          "a number from 1 to 100"};

inline constexpr NumberRule kModules{[](double x) { return x >= 0 && x <= 10 && is_quantity(x); },
                                     "a number of modules from 0 to 10"};

inline constexpr NumberRule kSliding{[](double x) { return x >= 1e-3 && x <= 1e6; },
                                     "a number from 0.001 to 1e6"};

inline constexpr NumberRule kShaftAngle{[](double x) { return x >= 10 && x <= 170; },
                                        "an angle in degrees from 10 to 170"};

inline constexpr NumberRule kDiameterQuotient{[](double x) { return x >= 3 && x <= 100; },
                                              "a number from 3 to 100"};

inline constexpr NumberRule kFriction{[](double x) { return x >= 0 && x <= 1 && is_quantity(x); },
                                      "a coefficient from 0 to 1"};

inline constexpr NumberRule kBacklash{[](double x) { return x >= 0 && is_quantity(x); },
                                      "0 or a length from 1e-30 to 1e30"};

/// Ends of a range; inf leaves it open.
inline constexpr NumberRule kDistanceLimit{
    [](double x) { return x >= 0 && (is_quantity(x) || x == kInfinity); },
    "0, a length from 1e-30 to 1e30 or inf"};

}  // namespace cognate::problems::reading
