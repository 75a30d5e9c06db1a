/// @file Angles that go on from one position to the next.
#pragma once

#include <cmath>
#include <span>

namespace cognate::problems {

/// Adds whole turns to `degrees`, each in (−180, 180], so that each differs from the one before it
/// by half a turn at most. What is not a number is passed over: after a gap the angle goes on from
/// where it was before.
inline void make_continuous(std::span<double> degrees) {
  constexpr double kTurn = 360;
  double before = 0;
  bool first = true;
  for (double& angle : degrees) {
    if (!std::isfinite(angle)) continue;
    if (!first) angle += kTurn * std::round((before - angle) / kTurn);
    before = angle;
    first = false;
  }
}

}  // namespace cognate::problems
