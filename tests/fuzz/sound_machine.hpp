/// @file What must hold of every machine that the reader accepts, for any file.
#pragma once

#include <algorithm>
#include <cmath>

#include "analysis/numbers/constants.hpp"
#include "problems/machine/problem.hpp"
#include "tests/fuzz/sound_analysis.hpp"

namespace cognate::problems {

/// Whether a function of the angle alone has a value wherever the reader looks, above 0 that of an
/// inertia, and its breaks are angles of a turn in order.
inline bool is_sound(const MachineFunction& function, bool positive) {
  if (!function.value || !std::ranges::is_sorted(function.breaks)) return false;
  if (!std::ranges::all_of(function.breaks, [&](double at) { return at >= 0 && at < kTurn; })) {
    return false;
  }
  if (function.of_speed || function.of_time) return !positive;
  for (int i = 0; i < 1440; i += 12) {
    const double value = function.value(kTurn * i / 1440, 1, 0);
    if (!std::isfinite(value) || (positive && !(value > 0))) return false;
    if (!function.table.empty() && !std::isfinite(function.slope(0.1 * i))) return false;
  }
  return !positive || function.slope;
}

inline bool is_sound(const MachineProblem& problem) {
  if (problem.run.tasks.empty() || (!problem.mechanism && !problem.inertia)) return false;
  if (problem.mechanism && !is_sound(*problem.mechanism)) return false;
  if (problem.inertia && !is_sound(*problem.inertia, true)) return false;
  if (problem.torque && !is_sound(*problem.torque, false)) return false;
  if (problem.motor && !problem.motor->torque.value) return false;
  return std::ranges::all_of(problem.loads, [](const MachineLoad& load) {
    return load.of_travel || is_sound(load.value, false);
  });
}

}  // namespace cognate::problems
