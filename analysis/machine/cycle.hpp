/// @file One period of a machine that turns on without stopping, integrated along its drive.
#pragma once

#include <vector>

#include "analysis/machine/adaptive_steps.hpp"
#include "analysis/machine/machine.hpp"
#include "analysis/machine/pieces.hpp"
#include "analysis/machine/torque_breakpoints.hpp"

namespace cognate::machine {

/// A speed that is an extreme, and where.
struct SpeedAt {
  double omega = 0;
  double phi = 0;
};

/// What a period was, in detail.
struct CycleDetail {
  std::vector<MachineState> states;  ///< at equal steps of φ, both ends included
  SpeedAt greatest, least;           ///< refined between the states
  double energy_swing = 0;           ///< greatest less least K, refined
  double motor_power = 0;            ///< greatest power of the motor, at the drive, refined
  double multiplier = 0;             ///< dω(end)/dω(beginning)
};

/// How a period ended: `gave_up` after too many steps, `stopped` from outside.
enum class CycleEnd { whole, open, gave_up, stopped };

/// Integrates dK/dφ = M piece by piece over a period from φ₀, so that no step crosses a break. The
/// derivative of J is not needed. Where K is used up the drive would stop; there the torques are
/// those at rest, so that the K at the end remains an increasing function of that at the beginning.
/// Of a machine so heavily damped that explicit steps are short for that alone, implicitly.
class Cycle {
 public:
  /// `work`: that of a period (J), above 0; the error of K is held against it or against K, which
  /// is less. `breakpoints` is one of this machine, which has its jumps among its breaks.
  Cycle(const Machine& machine, const TorqueBreakpoints& breakpoints, double phi0, double work,
        const Accuracy& accuracy);

  /// What K grows by in a period that begins with `kinetic`.
  CycleEnd run(double kinetic);
  double growth() const { return growth_; }
  double range() const { return greatest_ - least_; }     ///< of K
  bool stands() const { return kinetic_ + least_ <= 0; }  ///< whether K was used up
  double scale() const { return scale_; }                 ///< what the error of K is held against
  bool is_damped() const { return stepper_.is_implicit(); }  ///< implicitly integrated

  /// The same with other, shorter steps, to be compared.
  CycleEnd check(double kinetic);

  /// The same in detail, with these steps, for a period in which the drive does not stand.
  CycleEnd run(double kinetic, int steps, CycleDetail& detail);

 private:
  using State = AdaptiveSteps::State;

  /// What may be extreme at a place of the motion, and what vanishes there.
  struct Mark {
    SpeedAt at;
    double torque = 0;  ///< dK/dφ
    double bend = 0;    ///< J ω dω/dφ = M − ½ ω² dJ/dφ
    double power = 0;   ///< of the motor
  };

  CycleEnd go(double kinetic, CycleDetail* detail, int steps);
  void slope(const State& y, State& slope, double phi);
  State slope_at(double inertia, double speed, double time);
  Sensitivity<State> sensitivity(const State& y, const State& slope, double phi, double step);
  double kinetic(const State& y) const;
  double speed(double inertia, double kinetic) const;
  double torque_slope(double speed, double time) const;
  Mark mark(double phi, const State& y);
  double motor_power_slope(double phi, const State& y);
  double longest_step() const;
  CycleEnd run_piece(double to, CycleDetail* detail, int steps);
  CycleEnd count_step();
  double decay(double phi, double kinetic);
  void choose_method(bool implicit);
  void note_energy(const State& y);
  void note_extremes(CycleDetail& detail);
  void note_power(const Mark& before, CycleDetail& detail);
  MachineState state(double phi, const State& y);

  const Machine& machine_;
  const TorqueBreakpoints& breakpoints_;
  Accuracy accuracy_;
  Pieces pieces_;
  double phi0_, work_;
  double kinetic_ = 0, scale_ = 1, time_scale_ = 1;
  Place place_;
  bool detailed_ = false, fine_ = false, always_implicit_ = false;
  AdaptiveSteps stepper_;
  double growth_ = 0;
  double greatest_ = 0, least_ = 0;  ///< growth of K in between
  Mark last_;
  double power_change_ = 0;
  std::size_t taken_ = 0;
};

}  // namespace cognate::machine
