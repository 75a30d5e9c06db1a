/// @file A gait as reported quantities.
#pragma once

#include <vector>

#include "analysis/mechanism/gait.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/basics/quantity_key.hpp"

namespace cognate::problems {

inline constexpr QuantityKey<double> kDutyKey{"duty"}, kFlatnessKey{"flatness"};

/// In the file's unit of length, angles in degrees.
inline std::vector<Quantity> gait_quantities(const Gait& gait) {
  return {quantity(kDutyKey, gait.duty),          {"stride", gait.stride},
          {"step_height", gait.height},           quantity(kFlatnessKey, gait.flatness()),
          {"foot_speed_min", gait.speed_min},     {"foot_speed_max", gait.speed_max},
          {"stance_from_deg", degrees(gait.from)}};
}

}  // namespace cognate::problems
