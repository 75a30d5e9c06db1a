/// @file Which numbers an analysis takes: products of several of them, a mass by a length by the
/// square of a speed, must stay within the range of a double.
#pragma once

#include "problems/toml/number_rules.hpp"

namespace cognate::problems::reading {

constexpr bool is_positive_quantity(double x) {
  return x >= 1e-30 && x <= 1e30;
}

constexpr bool is_quantity(double x) {
  return x == 0 || is_positive_quantity(x < 0 ? -x : x);
}

inline constexpr NumberRule kQuantity{is_quantity, "a number, 0 or of magnitude 1e-30 to 1e30,"};

inline constexpr NumberRule kLinkLength{is_positive_quantity, "a length from 1e-30 to 1e30"};

inline constexpr NumberRule kMass{[](double x) { return x >= 0 && is_quantity(x); },
                                  "0 or a number from 1e-30 to 1e30"};

inline constexpr NumberRule kSpeedFluctuation{[](double x) { return x >= 1e-12 && x < 2; },
                                              "a number below 2, at least 1e-12,"};

inline constexpr NumberRule kShare{[](double x) { return x == 0 || (x >= 1e-12 && x <= 1); },
                                   "a fraction from 0 to 1"};

}  // namespace cognate::problems::reading
