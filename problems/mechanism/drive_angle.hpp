/// @file The angle of a machine's drive, which is counted on from turn to turn.
#pragma once

#include <algorithm>
#include <cmath>

namespace cognate::problems {

/// `phi` less whole periods, in [0, period).
inline double in_period(double phi, double period) {
  const double rest = phi - period * std::floor(phi / period);
  // Rounding may lead to the whole period, or to just below 0.
  return rest < period ? std::max(rest, 0.0) : 0;
}

}  // namespace cognate::problems
