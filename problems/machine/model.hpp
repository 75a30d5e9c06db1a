/// @file The machine of a file, as the integrators of analysis/machine know it.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "analysis/machine/machine.hpp"
#include "analysis/mechanism/assembly_ranges.hpp"
#include "problems/evaluation/active_loads.hpp"
#include "problems/linkage/result.hpp"
#include "problems/machine/load_travel.hpp"
#include "problems/machine/problem.hpp"

namespace cognate::problems {

/// The parts of a machine that vary between its tasks and searches.
struct MachineParts {
  double flywheel = 0;
  bool motor = true;
  double brake = 0;  ///< torque against the motion, a load
};

/// Prepared once, it makes machines; each has a state of its own. `deadline` and `problem` outlive
/// it.
class MachineModel {
 public:
  MachineModel(const MachineProblem& problem, const Deadline& deadline);

  machine::Machine machine(const MachineParts& parts) const;

  /// Whether the drive can turn fully; else `gap` says in words why not.
  bool turns() const { return gap_.empty(); }
  const std::string& gap() const { return gap_; }

  /// An angle of the drive at which the inertia vanishes, as where all that has mass stands still;
  /// empty where there is none, or the drive cannot turn fully.
  std::optional<double> without_inertia(double flywheel) const;

  /// Whether inertia or torques may depend on the drive's angle; torques on time.
  bool depends_on_angle() const;
  bool depends_on_time() const { return depends_on_time_; }

  double period() const { return period_; }
  std::uint64_t evaluations() const { return *evaluations_; }  ///< of inertia, by all machines

 private:
  void prepare_mechanism(const AnalysisProblem& mechanism, const Deadline& deadline);
  void add_breaks(const std::vector<double>& of_a_turn);
  void add_travel(const Mechanism<double>& mechanism, const MachineLoad& load);
  bool always_has_inertia(double flywheel) const;

  const MachineProblem& problem_;
  double period_;
  AssemblyRanges assembly_ranges_;
  std::vector<Stroke> strokes_;      ///< of the mechanism's loads, then of those that are functions
  std::vector<LoadTravel> travels_;  ///< of the bodies of the loads that are functions
  std::vector<double> walls_, breaks_;
  bool depends_on_time_ = false;
  std::string gap_;
  std::shared_ptr<std::uint64_t> evaluations_ = std::make_shared<std::uint64_t>(0);
};

}  // namespace cognate::problems
