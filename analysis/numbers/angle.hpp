/// @file Angles less whole turns.
#pragma once

#include <cmath>

#include "analysis/numbers/constants.hpp"

namespace cognate {

/// `angle` less whole turns, in [0, 2π).
inline double in_one_turn(double angle) {
  const double reduced = std::remainder(angle, kTurn);
  const double positive = reduced < 0 ? reduced + kTurn : reduced;
  return positive < kTurn ? positive : 0;  // a tiny negative angle rounds up to the whole turn
}

}  // namespace cognate
