/// @file What a machine's torques look like along its drive, by samples.
#pragma once

#include <span>
#include <vector>

#include "analysis/machine/machine.hpp"
#include "analysis/machine/step_limits.hpp"

namespace cognate::machine {

/// Where torques jump, and how long steps may be that jump over no narrow load. A load that acts
/// over less than a 3072nd of a turn may be missed. Inertias are not looked at, so that it is the
/// same with any flywheel.
class TorqueBreakpoints {
 public:
  explicit TorqueBreakpoints(const Machine& machine);

  /// Looks at the torques at each of these speeds, all the way round.
  void look(const Machine& machine, std::span<const double> speeds, double time = 0);

  /// Shortens all steps to this part of the period.
  void refine(double part) { limits_.shorten(part * period_); }

  /// The longest step from φ in [0, period].
  double longest_step(double phi) const { return limits_.at(phi); }

  /// The machine with the jumps that were found among its breaks.
  Machine cut(Machine machine) const;

 private:
  struct Torque;

  void find_jumps(const Machine& machine, const Torque& torque);
  void number_intervals();

  double period_;
  StepLimits limits_;
  std::vector<double> breaks_;  ///< those of the machine and the jumps found, ordered
  std::vector<int> stretches_;  ///< of each sample, by the breaks before it
};

}  // namespace cognate::machine
