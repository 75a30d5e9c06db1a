/// @file What must hold of every cam problem that the reader accepts, for any file.
#pragma once

#include <algorithm>
#include <cmath>

#include "analysis/cam/motion_programme.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/cam/problem.hpp"

namespace cognate::problems {

/// Whether the motion is one whole turn that can be followed, from the base circle and back to it,
/// and every length is a number within its bounds.
inline bool is_sound(const CamProblem& problem) {
  double turn = 0, place = 0, largest = 0;
  for (const cam::MotionSegment& segment : problem.motion) {
    turn += segment.over;
    place += segment.rise;
    largest = std::max(largest, std::abs(segment.rise));
  }
  if (!(std::abs(turn - kTurn) < 1e-6)) return false;
  if (!(std::abs(place) <= 1e-6 * largest)) return false;
  if (!cam::programme_of(problem.motion)) return false;
  return std::ranges::all_of(problem.lengths, [](const CamLength& length) {
    const auto& [min, max] = length.bounds;
    return !length.used ||
           (min <= max && (!length.given || (*length.given >= min && *length.given <= max)));
  });
}

}  // namespace cognate::problems
