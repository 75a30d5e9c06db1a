#include "problems/function/extreme_crank_angle.hpp"

#include <cmath>

#include "analysis/numbers/constants.hpp"

namespace cognate::problems {
namespace {

/// Whether `sweep`, turned by `start`, passes `angle`.
bool passes(const Range& sweep, double start, double angle) {
  const double turns = std::ceil((sweep.min + start - angle) / (kTurn));
  return angle + kTurn * turns <= sweep.max + start;
}

}  // namespace

ExtremeCrankAngle extreme_crank_angle(const Range& sweep, double start, double sense) {
  const double at_frame = sense > 0 ? 0 : kPi;
  if (passes(sweep, start, at_frame)) return {at_frame, false};
  const double low = sweep.min + start, high = sweep.max + start;
  return {sense * std::cos(low) > sense * std::cos(high) ? low : high, true};
}

}  // namespace cognate::problems
