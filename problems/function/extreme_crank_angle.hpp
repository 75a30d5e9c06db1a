/// @file Where within a sweep the transmission angle is extreme.
#pragma once

#include "problems/linkage/linkage_limits.hpp"

namespace cognate::problems {

struct ExtremeCrankAngle {
  double angle = 0;
  bool turns_with_start = false;  ///< an end of the sweep; else on the frame's line
};

/// The crank angle within `sweep`, turned by `start`, where its cosine is greatest (`sense` 1) or
/// least (−1).
ExtremeCrankAngle extreme_crank_angle(const Range& sweep, double start, double sense);

}  // namespace cognate::problems
