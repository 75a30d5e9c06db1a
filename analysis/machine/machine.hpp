/// @file A machine with one degree of freedom, reduced to the member that drives it.
///
/// With φ the drive's coordinate, ω its speed, J its equivalent inertia and M the equivalent torque
/// of all that acts (motor and loads),
///
///     J ω̇ + ½ ω² dJ/dφ = M(φ, ω, t),      or, with K = ½ J ω²,      dK/dφ = M.
///
/// Li & Xu 2011, chapter 6. Units: kg m², N m, rad, s (of a driving slider kg, N, m).
#pragma once

#include <functional>
#include <optional>
#include <vector>

namespace cognate::machine {

/// J and its derivative by φ; a flywheel and the motor's rotor included.
struct EquivalentInertia {
  double value = 0;
  double slope = 0;
};

/// What acts on the machine at (φ, ω, t).
struct Acting {
  EquivalentInertia inertia;
  double motor = 0;  ///< equivalent torque of the motor
  double load = 0;   ///< equivalent torque of loads and weights; against the motion negative
};

/// A machine as the integrators know it. `at` may be called from one thread at a time and allocates
/// nothing; it has no side effects. Where the mechanism cannot be assembled, its numbers are NaN.
struct Machine {
  std::function<Acting(double phi, double omega, double time)> at;
  double period = 0;             ///< in φ, of inertia and torques
  std::vector<double> breaks;    ///< φ in [0, period), increasing: where torque or dJ/dφ may jump
  bool depends_on_time = false;  ///< then there is no steady state to look for
};

/// A machine at an instant. `work` is what motor and loads have done since the beginning; the
/// kinetic energy grows by just as much, which the integrators do not use.
struct MachineState {
  double time = 0;
  double phi = 0;
  double omega = 0;
  double motor_work = 0;
  double load_work = 0;
};

/// Tolerances are relative to the state's own size.
struct Accuracy {
  double relative = 1e-10;
  std::size_t most_steps = 2'000'000;
};

}  // namespace cognate::machine
