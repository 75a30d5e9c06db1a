#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "problems/basics/names.hpp"
#include "problems/machine/gearing.hpp"
#include "problems/machine/keys.hpp"
#include "problems/machine/read_function.hpp"
#include "problems/machine/read_motor.hpp"
#include "problems/mechanism/drive_angle.hpp"
#include "problems/mechanism/part_names.hpp"
#include "problems/mechanism/read_links.hpp"
#include "problems/mechanism/read_whole_mechanism.hpp"
#include "problems/toml/nearest.hpp"

namespace cognate::problems::reading {
namespace {

constexpr std::string_view kTasks = "tasks";

std::optional<MachineTask> task_named(std::string_view word) {
  for (const auto& [name, task] : names<MachineTask>()) {
    if (name == word) return task;
  }
  return std::nullopt;
}

std::vector<MachineTask> read_tasks(TableReader& run) {
  std::vector<MachineTask> tasks;
  if (!run.has(kTasks)) return {MachineTask::steady};
  const auto words = run.texts(kTasks, {1, std::size(names<MachineTask>()), "tasks"});
  if (!words) return tasks;
  std::vector<std::string_view> allowed;
  for (const auto& named : names<MachineTask>()) allowed.push_back(named.name);
  for (std::size_t i = 0; i < words->size(); ++i) {
    const auto task = task_named((*words)[i]);
    if (!task) {
      const auto meant = nearest((*words)[i], allowed);
      run.faults().add(
          run.where(kTasks, i),
          fmt::format("entry {} of {} is {}{}; allowed are {}", i + 1, run.name(kTasks),
                      in_quotes((*words)[i]), meant ? ", perhaps for " + in_quotes(*meant) : "",
                      quoted_list(allowed)));
    } else if (std::ranges::find(tasks, *task) != tasks.end()) {
      run.faults().add(run.where(kTasks, i),
                       fmt::format("entry {} of {} is {} again; expected each task once", i + 1,
                                   run.name(kTasks), in_quotes((*words)[i])));
    } else {
      tasks.push_back(*task);
    }
  }
  return tasks;
}

/// Whether `task` is among those wanted.
bool asks_for(const MachineRunRequest& run, MachineTask task) {
  return std::ranges::find(run.tasks, task) != run.tasks.end();
}

/// The request in `table`, complete if no fault was added.
MachineRunRequest read_run(TableReader& table) {
  MachineRunRequest run;
  run.tasks = read_tasks(table);
  read_keys(table, kRunKeys, run);
  table.finish();
  return run;
}

/// The tables `[[load]]` of `table`, into `problem.mechanism` and `problem.loads`.
void read_machine_loads(TableReader& table, const PartNames& names, MachineProblem& problem) {
  constexpr std::string_view kValue = "value";
  for (TableReader& load : load_tables(table)) {
    const auto rule = read_load(load, names, false);
    const bool smooth = read_interpolation(load, {kValue});
    if (!load.has(kValue)) {
      if (rule) problem.mechanism->loads.push_back(*rule);
    } else if (auto value = read_machine_function(load, kValue, {FunctionOf::load}, smooth);
               value && rule) {
      problem.loads.push_back({*rule, std::move(value->function), std::move(value->of_travel)});
    }
    load.finish();
  }
}

constexpr std::string_view kMechanism = "mechanism";
constexpr std::string_view kEquivalent = "equivalent";
constexpr std::string_view kInertia = "inertia";
constexpr std::string_view kTorque = "torque";
constexpr std::string_view kFluctuation = "fluctuation";
constexpr std::string_view kFlywheel = "flywheel";
constexpr std::string_view kBrake = "brake";

void fault_sliding_drive(TableReader& mechanism) {
  mechanism.fault("type",
                  "is a chain that a slider or a cylinder drives; expected one that a crank "
                  "drives, which turns on and on");
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
  for (const std::string_view key : {"link", "load", "gravity", "point", "pivot", "crank", "slider",
                                     "cylinder", "dyad", "joint"}) {
    if (!document.has(key)) continue;
    document.fault(
        key,
        "is given without [mechanism], whose part it is; expected a [mechanism] with its "
        "type, or remove it");
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
    table.fault(kInertia, "is missing; expected an inertia, a torque, or both");
  }
  table.finish();
}

void read_flywheel(TableReader& document, MachineProblem& problem) {
  TableReader table = document.table(kFlywheel);
  read_keys(table, kFlywheelKeys, problem);
  if (table.has(kInertia) && table.has(kFluctuation)) {
    table.fault(
        kFluctuation,
        "is given beside flywheel.inertia; expected the flywheel that is there, or the fluctuation "
        "that one to be found shall leave");
  } else if (!table.has(kInertia) && !table.has(kFluctuation)) {
    table.fault(kInertia,
                "is missing; expected the flywheel's inertia, or the fluctuation that one to be "
                "found shall "
                "leave");
  } else if (table.has(kFluctuation) && !asks_for(problem.run, MachineTask::steady)) {
    table.fault(
        kFluctuation,
        "is of the steady motion, which run.tasks leaves out; expected \"steady\" among the tasks");
  }
  table.finish();
}

void read_brake(TableReader& document, MachineProblem& problem) {
  TableReader table = document.table(kBrake);
  if (!table.has(kTorque)) table.fault(kTorque, "is missing; expected the brake's torque");
  read_keys(table, kBrakeKeys, problem);
  if (!asks_for(problem.run, MachineTask::stop)) {
    table.fault(kTorque,
                "is of a stop, which run.tasks leaves out; expected \"stop\" among the tasks");
  }
  table.finish();
}

/// The unit that `document` gives, read and faulted elsewhere.
std::optional<LengthUnit> unit_of(TableReader& document) {
  constexpr std::string_view kUnit = "length_unit";
  if (!document.has_text(kUnit)) return std::nullopt;
  const auto word = document.text(kUnit);
  return word ? from_string<LengthUnit>(*word) : std::nullopt;
}

bool has_mass(const MachineProblem& problem) {
  const auto weighs = [](const Inertia& inertia) { return inertia.mass > 0 || inertia.moment > 0; };
  return problem.inertia || problem.flywheel > 0 ||
         (problem.motor && motor_inertia(*problem.motor) > 0) ||
         (problem.mechanism && std::ranges::any_of(problem.mechanism->inertias, weighs));
}

void check_mass(TableReader& document, const MachineProblem& problem) {
  if (has_mass(problem)) return;
  const std::string_view where = problem.mechanism ? kMechanism : kEquivalent;
  document.fault(
      where,
      "has no inertia, so that any torque would bring any speed at once; expected [[link]], "
      "equivalent.inertia, flywheel.inertia, motor.inertia or inertias of a motor.train");
}

}  // namespace

}  // namespace cognate::problems::reading

namespace cognate::problems {

MachineProblem KindTraits<MachineProblem>::read(reading::TableReader& document,
                                                const std::filesystem::path& folder) {
  using namespace reading;
  MachineProblem problem;
  TableReader run = document.table("run");
  problem.run = read_run(run);
  const bool has_mechanism = document.has(kMechanism);
  const bool has_equivalent = document.has(kEquivalent);
  if (!has_mechanism && !has_equivalent) {
    document.fault(
        kMechanism,
        "is missing; expected a [mechanism] with its links, or [equivalent] with inertia and "
        "torque at the drive");
  }
  if (has_mechanism) read_loaded_mechanism(document, problem);
  if (!has_mechanism) refuse_parts(document);
  if (has_equivalent) read_equivalent(document, problem);
  if (document.has("motor")) {
    TableReader motor = document.table("motor");
    problem.motor = read_motor(motor, {folder, unit_of(document)});
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

}  // namespace cognate::problems
