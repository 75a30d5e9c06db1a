/// A machine written down, and checked by reading what was written.
#include "problems/evaluation/write.hpp"

#include <fmt/core.h>

#include "problems/linkage/write_linkage.hpp"
#include "problems/machine/keys.hpp"
#include "problems/mechanism/write_mechanism.hpp"

namespace cognate::problems {
namespace reading {
namespace {

/// A function of the user's own stands in the document by its values at so many angles of a turn.
constexpr int kAnglesOfOwn = 360;

bool is_table(const MachineFunction& function) {
  return !function.table.empty();
}

/// `name` is that of the member, for a fault.
void write_function(const MachineFunction& function, std::string_view key, std::string_view name,
                    TableWriter& table, std::vector<std::string>& faults) {
  if (!function.text.empty()) {
    table.set(key, function.text);
  } else if (is_table(function)) {
    table.set(key, function.table);
  } else if (function.value && function.of_phi && !function.of_speed && !function.of_time) {
    Array rows;
    for (int i = 0; i < kAnglesOfOwn; ++i) {
      const double value = function.value(kTurn * i / kAnglesOfOwn, 0, 0);
      rows.push_back(node(Array{node(i), node(value)}));
    }
    table.set(key, rows);
  } else if (function.value) {
    table.set(key, function.value(0, 0, 0));
  }
  if (!function.value) {
    faults.push_back(fmt::format(
        "{} has no function of phi, omega and time; expected one, even with a text or table",
        name));
  }
}

void write_interpolation(const MachineFunction& function, TableWriter& table) {
  if (is_table(function)) table.set("interpolation", function.smooth ? "smooth" : "linear");
}

TableWriter equivalent_writer(const MachineProblem& problem, std::vector<std::string>& faults) {
  TableWriter table;
  if (problem.inertia) {
    write_function(*problem.inertia, "inertia", "equivalent.inertia", table, faults);
    if (problem.inertia->value && !problem.inertia->slope) {
      faults.emplace_back(
          "equivalent.inertia has no slope; expected its derivative by phi, as a function");
    }
  }
  if (problem.torque) write_function(*problem.torque, "torque", "equivalent.torque", table, faults);
  if (problem.inertia && is_table(*problem.inertia)) {
    write_interpolation(*problem.inertia, table);
  } else if (problem.torque) {
    write_interpolation(*problem.torque, table);
  }
  return table;
}

TableWriter motor_writer(const Motor& motor, std::vector<std::string>& faults) {
  TableWriter table;
  const MachineFunction& torque = motor.torque;
  if (motor.line) {
    TableWriter line;
    table.set("line", write_keys(*motor.line, kLineKeys, line));
    if (!torque.value) {
      faults.emplace_back("motor.torque has no function; expected that of the line");
    }
  } else {
    write_function(torque, is_table(torque) ? "table" : "torque", "motor.torque", table, faults);
    write_interpolation(torque, table);
  }
  if (motor.train) {
    Written train = KindTraits<GearTrainProblem>::written(motor.train->train);
    faults.insert(faults.end(), train.faults.begin(), train.faults.end());
    table.set("inertia", motor.inertia).set("train", std::move(train.document));
    return write_keys(*motor.train, kMotorTrainKeys, table);
  }
  return write_keys(motor, kMotorKeys, table);
}

TableWriter run_writer(const MachineRunRequest& run) {
  TableWriter table;
  Array tasks;
  for (const MachineTask task : run.tasks) tasks.push_back(node(to_string(task)));
  return write_keys(run, kRunKeys, table.set("tasks", tasks));
}

/// The loads that are functions.
Array function_loads(const MachineProblem& problem, std::vector<std::string>& faults) {
  const AnalysisProblem& given = *problem.mechanism;
  Array loads;
  for (const MachineLoad& load : problem.loads) {
    check_load(given, load.rule, faults);
    TableWriter table = load_writer(given, load.rule);
    if (load.value.text.empty() || load.value.value) {
      write_function(load.value, "value", "load.value", table, faults);
    } else if (load.of_travel) {
      table.set("value", load.value.text);
    }
    write_interpolation(load.value, table);
    loads.push_back(node(table));
  }
  return loads;
}

}  // namespace
}  // namespace reading

reading::Written KindTraits<MachineProblem>::written(const MachineProblem& problem) {
  using namespace reading;
  Written all;
  TableWriter document = document_writer(kWord, problem.title, problem.length_unit);
  if (problem.mechanism) {
    const Array loads = function_loads(problem, all.faults);
    document.set("mechanism", mechanism_writer(problem.mechanism->mechanism))
        .append(body_tables(*problem.mechanism, loads, all.faults));
  }
  if (problem.inertia || problem.torque) {
    document.set("equivalent", equivalent_writer(problem, all.faults));
  }
  if (problem.motor) document.set("motor", motor_writer(*problem.motor, all.faults));
  TableWriter flywheel;
  flywheel.set("fluctuation", problem.fluctuation);
  if (problem.flywheel != 0) flywheel.set("inertia", problem.flywheel);
  if (!flywheel.empty()) document.set("flywheel", flywheel);
  TableWriter brake;
  if (problem.brake) document.set("brake", write_keys(problem, kBrakeKeys, brake));
  all.document = document.set("run", run_writer(problem.run)).take();
  return all;
}

tl::expected<MachineProblem, std::vector<std::string>> KindTraits<MachineProblem>::checked(
    const MachineProblem& problem) {
  using namespace reading;
  const auto read = read_back(problem);
  if (!read) return tl::unexpected(read.error());
  MachineProblem complete = problem;
  if (problem.motor && problem.motor->train) {
    complete.motor->train->train = read->motor->train->train;
  }
  if (!problem.mechanism) return complete;
  std::vector<std::string> faults;
  check_same_mechanism(problem.mechanism->mechanism, read->mechanism->mechanism, faults);
  if (!faults.empty()) return tl::unexpected(faults);
  if (complete.mechanism->inertias.empty())
    complete.mechanism->inertias = read->mechanism->inertias;
  complete.mechanism->drive = read->mechanism->drive;
  return complete;
}

}  // namespace cognate::problems
