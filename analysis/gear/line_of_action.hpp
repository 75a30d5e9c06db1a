/// @file The line of action of a pair of spur gears, and the stretch of it where teeth touch.
#pragma once

#include <array>
#include <optional>

#include "analysis/gear/spur_pair.hpp"

namespace cognate::gear {

/// Places on the line of action are distances from T₁, where it touches the pinion's base circle,
/// towards T₂ on the wheel's.
struct LineOfAction {
  double pressure_angle = 0;  ///< α′
  double length = 0;          ///< T₁T₂ = a′ sin α′
  double pitch_point = 0;     ///< r_b1 tan α′
  double base_pitch = 0;      ///< π m cos α
  /// Where the path of contact would begin and end if only the tips limited it.
  double wheel_tip = 0, pinion_tip = 0;
  /// Where it would if only the form circles did.
  double pinion_form = 0, wheel_form = 0;
  /// The path of contact. The end is not before the start: where they are the same there is none.
  double start = 0, end = 0;
};

LineOfAction line_of_action(const SpurPair& pair);

/// Specific sliding of a flank, v_own − v_other over v_own as ISO 21771 has it. `own`: distance of
/// the contact from where the line of action touches the own base circle; `other`: the other
/// flank's velocity in units in which the own one is that distance. −∞ where contact is on the base
/// circle: on the line of action a millionth of the module is nothing.
double specific_sliding(double own, double other, double module);

/// Centre distances from `least` to `greatest`.
struct DistanceRange {
  double least = 0, greatest = 0;
};

/// The centre distances at which the contact ratio of `gears` is `ratio` > 0 or more, and their
/// teeth do not overlap; empty where there are none. The path of contact is the least of four
/// lengths: from tip to tip, which shrinks as the line of action grows, from form circle to form
/// circle, which grows with it, and those of either flank.
std::optional<DistanceRange> distances_in_contact(const std::array<SpurGear, 2>& gears,
                                                  double ratio);

}  // namespace cognate::gear
