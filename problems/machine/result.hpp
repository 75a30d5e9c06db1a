/// @file What a machine does.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/machine/flywheel.hpp"
#include "problems/evaluation/result.hpp"
#include "problems/linkage/result.hpp"
#include "problems/machine/problem.hpp"

namespace cognate::problems {

/// One of the motions that were requested, as a table: time, drive, speed, inertia, torques, power,
/// energies.
struct MachineMotion {
  MachineTask task = MachineTask::steady;
  /// "time_s" first, then "crank_deg" (not reduced to a turn)…; the same for every task.
  std::vector<Column> columns;
};

struct MachineResult {
  Status status = Status::no_solution;  ///< `solved` where every motion requested exists
  std::vector<MachineMotion> motions;
  std::vector<Quantity> quantities;
  Work work;
  std::vector<std::string> notes;
};

/// What the machine does, as far as it was requested.
MachineResult run_machine(const MachineProblem& problem, const Run& run);

}  // namespace cognate::problems
