/// @file The fillet of a gear: the envelope of the rounded tip of the rack that rolls on it.
#pragma once

#include "analysis/gear/spur_gear.hpp"
#include "analysis/numbers/vec2.hpp"

namespace cognate::gear {

/// The fillet to the right of a tooth space, in modules; the space's middle is the y axis, the
/// gear's centre the origin.
///
/// Its parameter θ is the angle below the x axis of the normal of the rack's corner at the point of
/// contact: π/2 at the root, the pressure angle where the straight flank begins. A normal at the
/// contact passes through the pitch point, so that the rack, its tooth in the middle of the space
/// at s = 0, has moved by s = −y cot θ − x, where (x, y) is the centre of the corner relative to
/// the pitch point at s = 0.
struct Fillet {
  double pitch_radius = 0;   ///< z/2
  Vec2d centre;              ///< of the corner
  double corner_radius = 0;  ///< of the rack's tip
  double end = 0;            ///< θ at the form circle; the fillet is from there to π/2

  /// Distance of the point from the gear's centre; falls as θ rises.
  double radius(double theta) const;
  /// Angle of the point clockwise of the space's middle.
  double angle(double theta) const;
  /// s, over the pitch radius: by which the gear has turned clockwise at the contact.
  double roll_angle(double theta) const;
};

/// The fillet of `gear`, with its end: of an undercut gear where it cuts the involute.
Fillet fillet_of(const SpurGear& gear);

}  // namespace cognate::gear
