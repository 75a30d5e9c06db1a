/// @file The periodic motion of a machine, by shooting.
#pragma once

#include <optional>
#include <vector>

#include "analysis/machine/cycle.hpp"
#include "analysis/machine/machine.hpp"
#include "analysis/machine/torque_breakpoints.hpp"

namespace cognate::machine {

/// Why there is no periodic motion.
enum class NoSteadyState {
  none,
  stalls,     ///< from every speed looked at the drive slows down until it stops
  stands,     ///< the drive uses its energy up within a period in which it would, kept at some
              ///< speed, gain as much as it loses
  runs_away,  ///< at every speed looked at motor and loads do more work than none
  any_speed,  ///< torques do not depend on speed and do no work in a period: every speed is one
  depends_on_time,
  open,     ///< the mechanism cannot be assembled all the way round
  gave_up,  ///< too many steps
  stopped,  ///< from outside
  unsure    ///< what was found does not stand when it is integrated with other steps
};

/// One period of the steady motion.
struct SteadyState {
  NoSteadyState missing = NoSteadyState::none;
  std::vector<MachineState> states;  ///< over one period, at equal steps of φ, both ends included
  SpeedAt greatest, least;           ///< of ω, refined between the states
  double multiplier = 0;  ///< dω(φ₀ + period)/dω(φ₀): below 1 where deviations die out
  /// The works of motor and loads in a period, and the growth of ½Jω² less those works, over what
  /// is worked in it; of the same period integrated in time, with other equations (of a machine
  /// too heavily damped for that, along φ).
  double energy_residual = 0;
  double energy_swing = 0;  ///< greatest less least ½Jω² (J), refined
  double motor_power = 0;   ///< the greatest at the drive (W), refined
  double surplus = 0;       ///< work of motor and loads in a period, where it does not vanish (J)
  int integrations = 0;     ///< periods integrated

  double period() const { return states.back().time; }
};

/// Where to look for the motion.
struct SteadyGuess {
  double phi = 0;                 ///< where the period begins, in [0, period)
  std::optional<double> speed{};  ///< there, above 0; else where the mean torques are balanced
};

/// (ω_max + ω_min)/2, and δ = (ω_max − ω_min) over that.
double mean_speed(const SteadyState& steady);
double fluctuation(const SteadyState& steady);

/// Orbits in a plane do not cross, so K(φ₀) ↦ K(φ₀ + period) is increasing; its fixed point at
/// which deviations die out is bracketed from the guess upwards where the drive gains speed, else
/// downwards. `steps`: how many equal steps of φ are recorded. Of `any_speed`, the states are those
/// at the guessed speed (or none, without one).
///
/// What is found is integrated again with other, shorter steps and in time; where growth or
/// energies differ by more than 1e-6 of what is worked, it is looked for again with shorter steps,
/// and in the end is `unsure`.
SteadyState steady_state(const Machine& machine, const SteadyGuess& guess, const Accuracy& accuracy,
                         int steps);

/// The same where the torque breakpoints of its torques is known.
SteadyState steady_state(const Machine& machine, TorqueBreakpoints breakpoints,
                         const SteadyGuess& guess, const Accuracy& accuracy, int steps);

/// The torque breakpoints at speeds about that of the guess.
TorqueBreakpoints breakpoints_about(const Machine& machine, const SteadyGuess& guess);

/// About the speed at which the torques, averaged over the period at constant speed, change from
/// driving to braking: the least such between 1e-4 and 7e5, else between 1e-30 and 1e30. Empty
/// where there is none.
std::optional<double> speed_of_mean_torques(const Machine& machine);

/// ∫ (|motor| + |load|) dφ over a period at about this speed (J), from samples: the greatest at
/// 0.8, 1 and 1.25 times it, since a motor without a load works at other speeds than its steady one
/// alone.
double turnover(const Machine& machine, double omega, double time = 0);

/// Whether torques at this speed differ from those at others, by more than rounding.
bool depends_on_speed(const Machine& machine, double omega);

}  // namespace cognate::machine
