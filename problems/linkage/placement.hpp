/// @file What is reported of a target that was moved, turned and enlarged.
#pragma once

#include <vector>

#include "problems/basics/degrees.hpp"
#include "problems/basics/quantity.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// "target_scale", "target_turn_deg" and the shift.
inline std::vector<Quantity> quantities(const CurvePlacement& placement) {
  return {{"target_scale", placement.scale},
          {"target_turn_deg", degrees(placement.turn)},
          {"target_shift_x", placement.shift.x},
          {"target_shift_y", placement.shift.y}};
}

}  // namespace cognate::problems
