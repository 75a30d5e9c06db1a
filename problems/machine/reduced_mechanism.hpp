/// @file A mechanism with its masses and loads, seen from its drive.
#pragma once

#include <vector>

#include "analysis/machine/machine.hpp"
#include "analysis/mechanism/followed_motion.hpp"
#include "problems/evaluation/active_loads.hpp"
#include "problems/machine/load_travel.hpp"
#include "problems/machine/problem.hpp"

namespace cognate::problems {

/// Evaluated once at a position, whose torques may then be requested at several speeds. Allocates
/// nothing after it is made.
class ReducedMechanism {
 public:
  /// `strokes`: of the mechanism's loads, then of `loads`; may be empty where no load needs them.
  /// `travels`: of the body of each of `loads`.
  ReducedMechanism(const AnalysisProblem& problem, const std::vector<MachineLoad>& loads,
                   const AssemblyRanges& assembly_ranges, const std::vector<Stroke>& strokes,
                   const std::vector<LoadTravel>& travels);

  /// Stands at `phi`, from 0 to the length of the assembly ranges (which may begin
  /// elsewhere). Not numbers where the mechanism cannot be assembled, or stands at a dead point.
  machine::EquivalentInertia move_to(double phi);

  /// Of weights and loads.
  double torque(double omega, double time);

 private:
  struct FunctionLoad {
    MachineLoad load;
    LoadTravel travel;
    ActiveLoads active;
  };

  double value(const FunctionLoad& load, double omega, double time) const;

  FollowedMotion<2> motion_;
  std::vector<Inertia> inertias_;
  Vec2d gravity_;
  ActiveLoads active_;
  std::vector<FunctionLoad> functions_;
  double phi_ = 0, weights_ = 0;
};

}  // namespace cognate::problems
