/// @file A gait as reported quantities.
#pragma once

#include <vector>

#include "analysis/mechanism/gait.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/basics/quantity.hpp"

namespace cognate::problems {

/// In the file's unit of length, angles in degrees.
inline std::vector<Quantity> gait_quantities(const Gait& gait) {
  return {{"duty", gait.duty},
          {"stride", gait.stride},
          {"step_height", gait.height},
          {"flatness", gait.flatness()},
          {"foot_speed_min", gait.speed_min},
          {"foot_speed_max", gait.speed_max},
          {"stance_from_deg", degrees(gait.from)}};
}

}  // namespace cognate::problems
