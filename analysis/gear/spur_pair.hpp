/// @file Two spur gears in mesh, at any centre distance.
///
/// Angles and contact ratio as Li & Xu 2011, 5.3, have them, with the working pressure angle from
/// cos α′ = (a/a′) cos α; sliding as ISO 21771. The pinion, the first gear, drives where one of the
/// two must.
#pragma once

#include <array>

#include "analysis/gear/spur_gear.hpp"

namespace cognate::gear {

/// Both are cut by the same rack and have the same module.
struct SpurPair {
  std::array<SpurGear, 2> gears;
  double centre_distance = 0;
};

/// r_b1 + r_b2: closer than this gears have no line of action.
double sum_of_base_radii(const std::array<SpurGear, 2>& gears);

/// α′ of cos α′ = (r_b1 + r_b2)/a′. Not a number where the centres are closer than the sum of base
/// radii.
double working_pressure_angle(const SpurPair& pair);

/// The centre distance at which the backlash, an arc on the working pitch circles, is `backlash`
/// ≥ 0; with none inv α′ = inv α + 2 (x₁ + x₂) tan α/(z₁ + z₂), less what teeth are thinner. Not a
/// number where no involute is that small.
double centre_distance_with_backlash(const std::array<SpurGear, 2>& gears, double backlash);
double centre_distance_without_backlash(const std::array<SpurGear, 2>& gears);

/// The sum of profile shifts with which two gears of these teeth and thinning have `backlash` at
/// `centre_distance`, for any shifts. Not a number where the centre distance is less
/// than the sum of base radii.
double profile_shift_sum(const std::array<SpurGear, 2>& gears, double centre_distance,
                         double backlash = 0);

/// What happens to one of the gears of a pair.
struct GearInMesh {
  double working_radius = 0;
  /// The least and the greatest radius of its flank that touch the other's; both that of the one
  /// point where the path would begin if there is no path.
  double contact_start = 0, contact_end = 0;
  /// By how much the other's tip digs into it: the most of the depth below its root circle, the arc
  /// by which the tip overlaps its fillet and, unless it is undercut, the length on the line of
  /// action by which the tip passes its form circle. 0 up to a billionth of the module.
  double interference = 0;
  double tip_clearance = 0;  ///< from its tip to the other's root; negative: the tip cuts in
  double sliding_start = 0;  ///< specific sliding 1 − v_other/v_own at contact_start…
  double sliding_end = 0;    ///< …and contact_end; −∞ on the base circle
};

/// What holds of the pair.
struct PairGeometry {
  double working_pressure_angle = 0;
  double contact_ratio = 0;  ///< length of the path of contact over the base pitch
  double path_length = 0;    ///< 0 where the flanks never meet on the line of action
  /// Path lengths before and after the pitch point; one is negative if that is not on the path.
  double approach = 0, recess = 0;
  double backlash = 0;                ///< arc on the working pitch circles; negative: teeth overlap
  double normal_backlash = 0;         ///< along the line of action
  double greatest_sliding_speed = 0;  ///< over the pitch line's speed, at an end of the path
  std::array<GearInMesh, 2> gears;
};

/// The path of contact goes from the wheel's tip to the pinion's, each where its tooth is pointed
/// if that is lower, but not below the form circle of either.
///
/// All is finite, but for sliding on a base circle, if the centre distance is more than the sum of
/// base radii and either gear has an involute (`tooth_fault`); else what depends on the working
/// pressure angle is not a number.
PairGeometry geometry(const SpurPair& pair);

/// The same in a tenth of the time, but that interference is only what root circles and the line of
/// action tell of it: where tips pass a fillet `add_fillet_interference` follows them.
PairGeometry geometry_of_line(const SpurPair& pair);
void add_fillet_interference(const SpurPair& pair, PairGeometry& geometry);

/// The pinion's profile shift, of those from `least` to `greatest`, with which the specific sliding
/// at the foot of both flanks is the same, with the sum of shifts and the centre distance of `pair`
/// and the tips of its gears going with their shifts. The end of the range that is nearer to it if
/// it is not within.
double balanced_shift(const SpurPair& pair, double least, double greatest);

}  // namespace cognate::gear
