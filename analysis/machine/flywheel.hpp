/// @file The flywheel that makes a machine run as evenly as desired.
#pragma once

#include <functional>

#include "analysis/machine/steady_state.hpp"

namespace cognate::machine {

/// Greatest less least of the work of what acts beyond its mean at a constant speed: ∫ (M − M̄) dφ
/// over a period from φ₀ (J). Not a number where that cannot be integrated.
double greatest_excess_work(const Machine& machine, double phi0, double omega,
                            const Accuracy& accuracy);

/// What the flywheel is for a fluctuation. What stands on the motion without a flywheel is not a
/// number where there is none.
struct Flywheel {
  double inertia = 0;      ///< to be added; 0 where the machine is even enough without
  double approximate = 0;  ///< ΔW_max/(ω_m² δ) − the mean of J_e, of textbooks; not below 0
  double greatest_excess = 0;  ///< ΔW_max, at the mean speed without a flywheel
  bool found = false;          ///< false where no flywheel does, or the search was ended
  NoSteadyState why = NoSteadyState::none;  ///< where none is found: of the last one looked at
  SteadyState without;                      ///< without it; may be missing
  SteadyState steady;                       ///< with it
};

/// The flywheel with which the steady state has the fluctuation `wanted` (above 0), exactly. Where
/// several have, one of the lesser: flywheels are doubled from a small one until the machine is
/// even enough. A machine that needs one to get round at all counts as uneven without. The mean
/// speed changes with the flywheel, which the textbooks' formula leaves out.
/// `machine_with(inertia)` is the machine with such a flywheel.
Flywheel flywheel_for(const std::function<Machine(double inertia)>& machine_with, double wanted,
                      const SteadyGuess& guess, const Accuracy& accuracy, int steps);

}  // namespace cognate::machine
