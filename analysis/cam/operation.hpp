/// @file How a cam runs: speed, masses, springs, loads, materials.
#pragma once

namespace cognate::cam {

/// What a follower must be pushed with, and what it is pushed by. Of an oscillating follower all is
/// about its pivot: moments, a moment of inertia, a spring's rate by the angle. Forces are in N,
/// moments in N·m; rates and moduli are by the unit in which the cam's lengths are.
struct Operation {
  double speed = 0;    ///< of the cam, rad/s, constant
  double inertia = 0;  ///< mass in kg; kg·m² about the pivot
  double spring_rate = 0;
  double preload = 0;  ///< of the spring at displacement 0
  double load = 0;     ///< against the rise, constant

  /// Line contact (Hertz 1882), where stress is requested.
  double width = 0;        ///< of the contact
  double modulus_sum = 0;  ///< (1 − ν₁²)/E₁ + (1 − ν₂²)/E₂

  double metres = 1;        ///< in the unit of the cam's lengths
  double displacement = 1;  ///< metres in the unit of the displacement; radians have 1
};

}  // namespace cognate::cam
