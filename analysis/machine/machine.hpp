/// @file A machine with one degree of freedom, reduced to the member that drives it.
///
/// With φ the drive's coordinate, ω its speed, J its equivalent inertia and M the equivalent torque
/// of all that acts (motor and loads),
///
///     J ω̇ + ½ ω² dJ/dφ = M(φ, ω, t),      or, with K = ½ J ω²,      dK/dφ = M.
///
/// Li & Xu 2011, chapter 6. Units: kg m², N m, rad, s.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace cognate::machine {

/// J and its derivative by φ; a flywheel and the motor's rotor included.
struct EquivalentInertia {
  double value = 0;
  double slope = 0;
};

/// Equivalent torques, positive where they push towards greater φ.
struct Torques {
  double motor = 0;
  double load = 0;  ///< of loads and weights

  double sum() const { return motor + load; }
};

/// A machine as the integrators know it. Its functions may be called from one thread at a time and
/// allocate nothing. Where the mechanism cannot be assembled, their numbers are NaN.
struct Machine {
  /// Moves it to φ in [0, period]; torques are evaluated afterwards.
  std::function<EquivalentInertia(double phi)> move_to;
  /// What acts where it stands. The sign of ω is the direction of motion, even where it is tiny.
  std::function<Torques(double omega, double time)> torques;
  double period = 0;  ///< in φ, of inertia and torques
  std::vector<double>
      breaks{};  ///< φ in [0, period), increasing: where torque or J may jump or bend
  bool depends_on_time = false;  ///< then there is no steady state to look for
};

/// A machine at an instant. `work` is what motor and loads have done since the beginning.
struct MachineState {
  double time = 0;
  double phi = 0;  ///< counted on from turn to turn
  double omega = 0;
  double motor_work = 0;
  double load_work = 0;
};

/// How exactly to integrate, and when to give up.
struct Accuracy {
  double relative = 1e-10;  ///< error of a step, relative to the state and to the work of a period
  std::size_t most_steps = 500'000;  ///< of one integration
  std::function<bool()> stop{};      ///< asked now and then
};

}  // namespace cognate::machine
