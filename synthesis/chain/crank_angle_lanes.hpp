/// @file Crank angles of many chains at a time, one in each SIMD lane. Include in kernels alone.
#pragma once

#include "synthesis/lanes/lane_directions.hpp"

namespace cognate::synthesis::COGNATE_ISA {

/// arctan(step/2) where |step| is at most about 0.5, to rounding.
inline Real half_angle(const Real& step) {
  const Real t = Real(0.5) * step, s = t * t;
  Real sum(0.0);
  for (int power = 19; power >= 1; power -= 2) {
    sum = sum * s + Real((power / 2) % 2 == 0 ? 1.0 / power : -1.0 / power);
  }
  return t * sum;
}

/// e^{i·angle} to rounding where |angle| is at most about 0.5.
inline Direction small_rotation(const Real& angle) {
  const Real s = angle * angle;
  const Real cosine =
      Real(1.0) +
      s * (Real(-1.0 / 2) +
           s * (Real(1.0 / 24) +
                s * (Real(-1.0 / 720) + s * (Real(1.0 / 40320) - s * Real(1.0 / 3628800)))));
  const Real sine =
      angle *
      (Real(1.0) +
       s * (Real(-1.0 / 6) +
            s * (Real(1.0 / 120) +
                 s * (Real(-1.0 / 5040) + s * (Real(1.0 / 362880) - s * Real(1.0 / 39916800))))));
  return {cosine, sine};
}

/// Brings `next_angles` in the order of `angles`, `closed`: within a turn: to half-way between two
/// sequences that are in order, one pushed forwards from the first angle, one backwards from the
/// last. Of each gap a share of what it was is left. `pushed` is room for as many.
inline void keep_order(const double* angles, double* next_angles, double* pushed, int count,
                       bool closed) {
  constexpr double kLeastShare = 0.1;  // of the step between two angles that must be left
  const int last = count - 1;
  const Real share(kLeastShare), turn(2 * 3.14159265358979323846);
  const auto own = [&](int j) { return load(angles + j * kLanes); };
  const Real sense = choose(own(last) > own(0), Real(1.0), Real(-1.0));
  const auto gap = [&](int j) { return share * magnitude(own(j) - own(j - 1)); };
  const Real seam = turn - magnitude(own(last) - own(0));
  const Real most = closed ? turn - share * seam : Real(1e300);
  const auto next = [&](int j) { return sense * load(next_angles + j * kLanes); };
  Real before = larger(next(0), next(last) - most);
  store(before, pushed);
  for (int j = 1; j <= last; ++j) {
    before = larger(next(j), before + gap(j));
    store(before, pushed + j * kLanes);
  }
  Real after = smaller(next(last), next(0) + most);
  for (int j = last; j >= 0; --j) {
    if (j < last) after = smaller(next(j), after - gap(j + 1));
    store(Real(0.5) * (after + load(pushed + j * kLanes)), pushed + j * kLanes);
  }
  // Both sequences may together go more than once round: what is too much is cut off at the ends.
  const Real first = load(pushed), end = load(pushed + last * kLanes);
  const Real excess = Real(0.5) * larger(Real(0.0), end - first - most);
  for (int j = 0; j <= last; ++j) {
    const Real within = larger(first + excess, smaller(end - excess, load(pushed + j * kLanes)));
    store(sense * within, next_angles + j * kLanes);
  }
}

}  // namespace cognate::synthesis::COGNATE_ISA
