/// @file A pinion that meshes with a ring, both spur.
///
/// Both lie on the same side of the pitch point: cos α′ = (r_b2 − r_b1)/a′, and on the line of
/// action the ring's tangent point T₂ is a′ sin α′ before the pinion's T₁. Interferences as in
/// Colbourne, The Geometry of Involute Gears, 1987, chapter 8.
#pragma once

#include "analysis/gear/ring_gear.hpp"
#include "analysis/gear/spur_pair.hpp"

namespace cognate::gear {

/// Both have the same module and basic rack; the ring has more teeth.
struct InternalPair {
  SpurGear pinion;
  RingGear ring;
  double centre_distance = 0;
};

/// The centre distance at which the backlash, an arc on the working pitch circles, is `backlash`:
/// with none inv α′ = inv α + 2 (x₂ − x₁) tan α/(z₂ − z₁). Not a number where there is none; with
/// backlash the greater of two.
double internal_centre_distance(const SpurGear& pinion, const RingGear& ring, double backlash);

struct InternalGeometry {
  /// Of the ring `contact_start` is at its root, outside. Interference: by how much a tip passes
  /// the other's form circle along the line of action.
  PairGeometry mesh;
  double path_start = 0, path_end = 0;  ///< on the line of action, from T₁; may be negative
  /// The least angle of the pinion, times its teeth, between the tips of both after contact: the
  /// tips overlap where it is negative. Infinite where the tip circles do not cross.
  double tip_room = 0;
  /// The same while the pinion is moved into the ring radially; where it is negative the pinion
  /// goes in along the axis alone.
  double radial_room = 0;
};

/// All is a number where the ring can be made, the pinion has an involute, and a′ > r_b2 − r_b1.
InternalGeometry geometry(const InternalPair& pair);

/// The angle from the y axis by which the ring's first tooth is turned, its centre at (0, −a′),
/// when the pinion's at the origin is not, and the left flank of its first tooth touches where the
/// teeth mesh: with backlash that flank alone.
double ring_angle(const InternalPair& pair);

}  // namespace cognate::gear
