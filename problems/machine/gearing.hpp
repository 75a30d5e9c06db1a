/// @file The gears between a motor and the drive.
#pragma once

#include <vector>

#include "problems/basics/quantity.hpp"
#include "problems/machine/problem.hpp"

namespace cognate::problems {

/// Gears as the machine's equation of motion knows them.
struct MotorGearing {
  double ratio = 1;       ///< motor speed over drive speed; of a reversed motor its negative
  double efficiency = 1;  ///< of power from the motor to the drive
  double reverse_efficiency = 1;  ///< of power from the drive to the motor; 0: self-locking
  double inertia = 0;             ///< of the gears, equivalent at the drive

  bool is_self_locking() const { return reverse_efficiency == 0; }

  /// The torque on the drive, ω being its speed, of a motor with `torque` at its own shaft. Where
  /// the motor brakes, power flows back through the gears. A self-locking train has none of that:
  /// against `load`, the torque of all else on the drive, it holds a motor that is off, and one
  /// that brakes as if it passed back a hundredth, so that the load can barely hurry it.
  double torque_at_drive(double torque, double omega, double load) const;
};

/// Of a valid motor.
MotorGearing gearing_of(const Motor& motor);

/// Of rotor and gears, equivalent at the drive, of a valid motor.
double motor_inertia(const Motor& motor);

/// train_ratio, train_ratio_exact, train_efficiency, train_reverse_efficiency (none of a
/// self-locking train), train_self_locking, train_inertia_kg_m2; none of a motor without a train.
std::vector<Quantity> train_quantities(const Motor& motor);

}  // namespace cognate::problems
