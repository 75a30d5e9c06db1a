/// @file The flywheel that makes a machine run as evenly as wanted.
#pragma once

#include <functional>

#include "analysis/machine/steady_state.hpp"

namespace cognate::machine {

/// Greatest less least of the work of what acts beyond its mean at a constant speed: ∫ (M − M̄) dφ
/// over a period from φ₀ (J). Not a number where that cannot be integrated.
double greatest_excess_work(const Machine& machine, double phi0, double omega,
                            const Accuracy& accuracy);

/// What the flywheel is for a fluctuation.
struct Flywheel {
  double inertia = 0;      ///< to be added; 0 where the machine is even enough without
  double approximate = 0;  ///< ΔW_max/(ω_m² δ) − the mean of J_e, of textbooks; not below 0
  double greatest_excess = 0;  ///< ΔW_max, at the mean speed without a flywheel
  bool found = false;          ///< false where no flywheel does, or `without` has no steady state
  SteadyState without;         ///< without it
  SteadyState steady;          ///< with it
};

/// The flywheel with which the steady state has the fluctuation `wanted` (above 0), exactly: the
/// least, if several have. The mean speed changes with the flywheel, which the textbooks' formula
/// leaves out. `machine_with(inertia)` is the machine with such a flywheel.
Flywheel flywheel_for(const std::function<Machine(double inertia)>& machine_with, double wanted,
                      const SteadyGuess& guess, const Accuracy& accuracy, int steps);

}  // namespace cognate::machine
