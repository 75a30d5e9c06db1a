/// @file How the gears of a pair stand to one another while they turn.
#pragma once

#include <array>

#include "analysis/gear/line_of_action.hpp"
#include "analysis/numbers/vec2.hpp"

namespace cognate::gear {

/// A pair whose pinion drives counter-clockwise: the pinion's centre at the origin, the wheel's at
/// (0, a′). Angles are those by which the outlines of `gear_outline` have turned counter-clockwise.
///
/// When the pinion's angle is φ the wheel's is wheel_angle − φ z₁/z₂, the left flank of a tooth of
/// the pinion touches the wheel's, and the backlash is all on the other side. Teeth touch at T₁ +
/// (contact + φ r_b1 + k p_b) · direction, k any integer, wherever that is from A to E.
struct Mesh {
  Vec2d wheel_centre{};
  std::array<Vec2d, 2> base_points{};  ///< T₁, T₂: where the line of action touches base circles
  Vec2d direction{};                   ///< the unit vector from T₁ to T₂
  Vec2d pitch_point{};                 ///< C
  Vec2d path_start{}, path_end{};      ///< A, E
  double wheel_angle = 0;
  double contact = 0;  ///< from T₁, the first at A or after it
  LineOfAction line;
};

/// Not numbers where the base circles overlap.
Mesh mesh(const SpurPair& pair);

}  // namespace cognate::gear
