/// @file The angle of a machine's drive, which is counted on from turn to turn.
#pragma once

#include <cmath>
#include <numbers>

namespace cognate::problems {

inline constexpr double kTurn = 2 * std::numbers::pi;

/// `phi` less whole periods, in [0, period).
inline double in_period(double phi, double period) {
  const double rest = phi - period * std::floor(phi / period);
  return rest < period ? rest : 0;  // a tiny negative angle rounds up to the whole period
}

}  // namespace cognate::problems
