/// @file One period of a machine that turns on without stopping, integrated along its drive.
#pragma once

#include <vector>

#include "analysis/machine/adaptive_steps.hpp"
#include "analysis/machine/machine.hpp"
#include "analysis/machine/pieces.hpp"

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
  double multiplier = 0;             ///< dω(end)/dω(beginning)
};

/// How a period ended: `gave_up` is for too many steps or because it was stopped.
enum class CycleEnd { whole, open, gave_up };

/// Integrates dK/dφ = M piece by piece over a period from φ₀, so that no step crosses a break. The
/// derivative of J is not needed. Where K is used up the drive would stop; there the torques are
/// those at rest, so that the K at the end remains an increasing function of that at the beginning.
class Cycle {
 public:
  /// `work`: what to hold the error of K against (J), above 0.
  Cycle(const Machine& machine, double phi0, double work, const Accuracy& accuracy);

  /// What K grows by in a period that begins with `kinetic`.
  CycleEnd run(double kinetic);
  double growth() const { return growth_; }
  double range() const { return greatest_ - least_; }  ///< of K
  bool stands() const { return least_ <= 0; }          ///< whether K was used up

  /// The same in detail, for a period in which the drive does not stand.
  CycleEnd run(double kinetic, int steps, CycleDetail& detail);

 private:
  using State = AdaptiveSteps::State;

  void slope(const State& y, State& slope, double phi);
  double omega(double inertia, double scaled);
  double bend(double phi, const State& y);
  CycleEnd run_piece(double to, CycleDetail* detail, int steps);
  void note_extreme(CycleDetail& detail);
  MachineState state(double phi, const State& y);

  const Machine& machine_;
  Accuracy accuracy_;
  Pieces pieces_;
  double phi0_, work_;
  double kinetic_ = 0, time_scale_ = 1;
  Place place_;
  bool detailed_ = false;
  AdaptiveSteps stepper_;
  double growth_ = 0, greatest_ = 0, least_ = 0;
  std::size_t taken_ = 0;
};

}  // namespace cognate::machine
