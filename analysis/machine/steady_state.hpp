/// @file The periodic motion of a machine, by shooting, and the flywheel that makes it even.
#pragma once

#include <optional>
#include <vector>

#include "analysis/machine/machine.hpp"

namespace cognate::machine {

/// Why there is no periodic motion.
enum class NoSteadyState {
  none,
  stalls,     ///< at every speed the loads take more work in a period than the motor gives
  runs_away,  ///< at every speed the motor gives more: the speed grows without bound
  any_speed,  ///< torques do not depend on speed and do no work in a period: every speed is one
  depends_on_time,
  open  ///< the mechanism cannot be assembled all the way round
};

/// One period of the steady motion.
struct SteadyState {
  NoSteadyState missing = NoSteadyState::none;
  std::vector<MachineState> states;  ///< over one period, at equal steps of φ and at the breaks
  double greatest_speed = 0, least_speed = 0;  ///< refined between the states
  double phi_at_greatest = 0, phi_at_least = 0;
  double period = 0;           ///< in time
  double multiplier = 0;       ///< dω(φ₀ + period)/dω(φ₀): below 1 where deviations die out
  double energy_residual = 0;  ///< work of a period over the work the motor does in it
  int integrations = 0;        ///< periods integrated until the shooting was done
};

/// δ = (ω_max − ω_min)/ω_m with ω_m = ½ (ω_max + ω_min).
double fluctuation(const SteadyState& steady);

/// Orbits in a plane do not cross, so ω(φ₀) ↦ ω(φ₀ + period) is increasing and its fixed point is
/// bracketed; `guess` is where to look first (a speed above 0). `steps`: how many equal steps of φ
/// are recorded.
SteadyState steady_state(const Machine& machine, double guess, const Accuracy& accuracy, int steps);

/// What the flywheel is for a fluctuation.
struct Flywheel {
  double inertia = 0;          ///< to be added; 0 where the machine is even enough without
  double approximate = 0;      ///< ΔW_max/(ω_m² δ) − J_e of the textbooks
  double greatest_excess = 0;  ///< ΔW_max
  SteadyState steady;          ///< with it
};

/// The flywheel with which the steady state has the fluctuation `wanted`, exactly: the least if
/// several have. `machine_with(inertia)` is the machine with such a flywheel.
Flywheel flywheel_for(const std::function<Machine(double inertia)>& machine_with, double wanted,
                      double guess, const Accuracy& accuracy, int steps);

}  // namespace cognate::machine
