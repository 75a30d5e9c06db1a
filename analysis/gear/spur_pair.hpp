/// @file Two spur gears in mesh, at any centre distance.
///
/// Angles and contact ratio as Li & Xu 2011, 5.3, have them, with the working pressure angle from
/// cos α′ = (a/a′) cos α; sliding as ISO 21771. The pinion drives where one of the two must.
#pragma once

#include <array>

#include "analysis/gear/spur_gear.hpp"

namespace cognate::gear {

/// Both are cut by the same rack and have the same module.
struct SpurPair {
  std::array<SpurGear, 2> gears;
  double centre_distance = 0;
};

/// The centre distance at which the backlash is zero: inv α′ = inv α + 2 (x₁ + x₂) tan α/(z₁ + z₂),
/// less what teeth are thinner. Not a number where no angle is that small.
double centre_distance_without_backlash(const std::array<SpurGear, 2>& gears);

/// The sum of profile shifts with which two gears of these teeth have no backlash at
/// `centre_distance`. Not a number where the centre distance is less than the sum of base radii.
double profile_shift_sum(const std::array<SpurGear, 2>& gears, double centre_distance);

/// What happens to one of the gears of a pair.
struct GearInMesh {
  double working_radius = 0;
  /// The least and the greatest radius of its flank that touch the other's.
  double contact_start = 0, contact_end = 0;
  /// Where the mating tip would touch it: of interference this is below the form radius.
  double reached_radius = 0;
  bool interferes = false;   ///< the other's tip meets its fillet or passes its base tangent
  double tip_clearance = 0;  ///< from its tip to the other's root
  double sliding_start = 0;  ///< specific sliding 1 − v_other/v_own at contact_start…
  double sliding_end = 0;    ///< …and contact_end; −∞ on the base circle
};

/// What holds of the pair.
struct PairGeometry {
  double working_pressure_angle = 0;
  double contact_ratio = 0;  ///< length of the path of contact over the base pitch
  double path_length = 0;
  double approach = 0, recess = 0;    ///< path lengths before and after the pitch point
  double backlash = 0;                ///< arc on the working pitch circles; negative: teeth overlap
  double normal_backlash = 0;         ///< along the line of action
  double greatest_sliding_speed = 0;  ///< over the pitch line's speed, at an end of the path
  std::array<GearInMesh, 2> gears;
};

/// Nothing but numbers if the centre distance is at least the sum of base radii.
PairGeometry geometry(const SpurPair& pair);

}  // namespace cognate::gear
