/// @file A chain moved, turned and enlarged as a whole.
#pragma once

#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "analysis/numbers/vec2.hpp"
#include "synthesis/chain/chain.hpp"

namespace cognate::synthesis {

/// Changes the parameters of a chain so that every point p of it comes to `shift` + `turn`·p, for a
/// crank at the angle of `turn` more. `turn`, a complex number, turns and enlarges.
inline void transform(std::span<const PlacedLine> lines, const Vec2d& turn, const Vec2d& shift,
                      std::vector<double>& parameters) {
  const double size = std::sqrt(squared_norm(turn));
  const double angle = std::atan2(turn.y, turn.x);
  for (const auto& [line, parameter] : lines) {
    double* own = parameters.data() + parameter;
    if (parameter_role(line.type, 0) == ParameterRole::x) {
      const Vec2d moved = shift + turn * Vec2d{own[0], own[1]};
      own[0] = moved.x;
      own[1] = moved.y;
      continue;
    }
    for (int i = 0; i < parameter_count(line.type); ++i) {
      const ParameterRole role = parameter_role(line.type, i);
      if (role == ParameterRole::direction) {
        own[i] = std::remainder(own[i] + angle, 2 * std::numbers::pi);
      } else if (role != ParameterRole::body_angle) {
        own[i] *= size;
      }
    }
  }
}

}  // namespace cognate::synthesis
