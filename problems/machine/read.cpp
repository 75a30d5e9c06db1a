#include "problems/machine/read.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "analysis/numbers/constants.hpp"
#include "problems/machine/read_function.hpp"
#include "problems/machine/read_loads.hpp"
#include "problems/machine/read_motor.hpp"
#include "problems/machine/read_run.hpp"
#include "problems/mechanism/drive_angle.hpp"
#include "problems/mechanism/quantity_rules.hpp"
#include "problems/mechanism/read_links.hpp"
#include "problems/mechanism/read_whole_mechanism.hpp"

namespace cognate::problems::reading {
namespace {

constexpr std::string_view kMechanism = "mechanism";
constexpr std::string_view kEquivalent = "equivalent";
constexpr std::string_view kInertia = "inertia";
constexpr std::string_view kTorque = "torque";
constexpr std::string_view kFluctuation = "fluctuation";
constexpr std::string_view kFlywheel = "flywheel";
constexpr std::string_view kBrake = "brake";

constexpr NumberRule kPositiveTorque{is_positive_quantity, "a torque from 1e-30 to 1e30"};
constexpr NumberRule kUnevenness{[](double x) { return x >= 1e-6 && x <= 1; },
                                 "(greatest - least speed)/mean from 1e-6 to 1"};

void fault_sliding_drive(TableReader& mechanism) {
  mechanism.fault("type",
                  "is a chain that a slider drives; one that a crank drives, which turns on and "
                  "on, is wanted");
}

void read_loaded_mechanism(TableReader& document, MachineProblem& problem) {
  TableReader mechanism = document.table(kMechanism);
  AnalysisProblem& read = problem.mechanism.emplace();
  auto whole = read_whole_mechanism(document, mechanism);
  const PartNames names = whole ? std::move(whole->names) : unknown_parts(document);
  read.inertias = read_links(holder("link", document, mechanism), names);
  read_machine_loads(holder("load", document, mechanism), names, problem);
  read.gravity = read_gravity(holder("gravity", document, mechanism));
  if (!whole) return;
  if (is_slider_driven(whole->mechanism)) fault_sliding_drive(mechanism);
  read.mechanism = std::move(whole->mechanism);
  mechanism.finish();
}

// Tables that say nothing without a mechanism.
void refuse_parts(TableReader& document) {
  for (const std::string_view key :
       {"link", "load", "gravity", "point", "pivot", "crank", "slider", "dyad"}) {
    if (!document.has(key)) continue;
    document.fault(key,
                   "is given without [mechanism], whose part it is; a [mechanism] with its "
                   "type is wanted, or leave it out");
  }
}

void read_equivalent(TableReader& document, MachineProblem& problem) {
  TableReader table = document.table(kEquivalent);
  const bool smooth = read_interpolation(table, {kInertia, kTorque});
  if (table.has(kInertia)) {
    auto inertia = read_machine_function(table, kInertia, {FunctionOf::phi, true}, smooth);
    if (inertia) problem.inertia = std::move(inertia->function);
  }
  if (table.has(kTorque)) {
    auto torque = read_machine_function(table, kTorque, {}, smooth);
    if (torque) problem.torque = std::move(torque->function);
  }
  if (!table.has(kInertia) && !table.has(kTorque)) {
    table.fault(kInertia, "is missing; an inertia, a torque, or both are wanted");
  }
  table.finish();
}

void read_flywheel(TableReader& document, MachineProblem& problem) {
  TableReader table = document.table(kFlywheel);
  problem.flywheel = table.number(kInertia, kMass).value_or(0);
  problem.fluctuation = table.number(kFluctuation, kUnevenness);
  if (table.has(kInertia) && table.has(kFluctuation)) {
    table.fault(kFluctuation,
                "is given beside flywheel.inertia; the flywheel that is there, or the fluctuation "
                "that one to be found shall leave, is wanted");
  } else if (!table.has(kInertia) && !table.has(kFluctuation)) {
    table.fault(kInertia,
                "is missing; the flywheel's inertia, or the fluctuation that one to be found shall "
                "leave, is wanted");
  } else if (table.has(kFluctuation) && !asks_for(problem.run, MachineTask::steady)) {
    table.fault(kFluctuation,
                "is of the steady motion, which run.tasks leaves out; \"steady\" among the tasks "
                "is wanted");
  }
  table.finish();
}

void read_brake(TableReader& document, MachineProblem& problem) {
  TableReader table = document.table(kBrake);
  if (!table.has(kTorque)) table.fault(kTorque, "is missing; the brake's torque is wanted");
  problem.brake = table.number(kTorque, kPositiveTorque);
  if (!asks_for(problem.run, MachineTask::stop)) {
    table.fault(kTorque,
                "is of a stop, which run.tasks leaves out; \"stop\" among the tasks is "
                "wanted");
  }
  table.finish();
}

bool has_mass(const MachineProblem& problem) {
  const auto weighs = [](const Inertia& inertia) { return inertia.mass > 0 || inertia.moment > 0; };
  return problem.inertia || problem.flywheel > 0 || (problem.motor && problem.motor->inertia > 0) ||
         (problem.mechanism && std::ranges::any_of(problem.mechanism->inertias, weighs));
}

void check_mass(TableReader& document, const MachineProblem& problem) {
  if (has_mass(problem)) return;
  const std::string_view where = problem.mechanism ? kMechanism : kEquivalent;
  document.fault(where,
                 "has no inertia, so that any torque would bring any speed at once; [[link]], "
                 "equivalent.inertia, flywheel.inertia or motor.inertia is wanted");
}

}  // namespace

MachineProblem read_machine_problem(TableReader& document) {
  MachineProblem problem;
  TableReader run = document.table("run");
  problem.run = read_run(run);
  const bool has_mechanism = document.has(kMechanism);
  const bool has_equivalent = document.has(kEquivalent);
  if (!has_mechanism && !has_equivalent) {
    document.fault(kMechanism,
                   "is missing; a [mechanism] with its links, or [equivalent] with inertia and "
                   "torque at the drive, is wanted");
  }
  if (has_mechanism) read_loaded_mechanism(document, problem);
  if (!has_mechanism) refuse_parts(document);
  if (has_equivalent) read_equivalent(document, problem);
  if (document.has("motor")) {
    TableReader motor = document.table("motor");
    problem.motor = read_motor(motor);
  }
  if (document.has(kFlywheel)) read_flywheel(document, problem);
  if (document.has(kBrake)) read_brake(document, problem);
  if (document.faults().empty()) check_mass(document, problem);
  if (problem.mechanism) {
    problem.mechanism->drive = {.start = problem.run.start_phi,
                                .end = problem.run.start_phi + kTurn,
                                .steps = problem.run.steps,
                                .rate = {1, 0}};
  }
  return problem;
}

}  // namespace cognate::problems::reading
