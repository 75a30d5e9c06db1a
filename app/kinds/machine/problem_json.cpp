#include "app/kinds/evaluation/problem_json.hpp"

#include <nlohmann/json.hpp>

#include "app/documents/json_values.hpp"
#include "app/kinds/machine/kind.hpp"
#include "problems/basics/names.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;
using problems::MachineFunction;
using problems::MachineProblem;

/// As the file writes it: an expression, a table or a number.
ordered_json function_json(const MachineFunction& function) {
  if (!function.text.empty()) return function.text;
  if (function.table.empty()) return function.value(0, 0, 0);
  ordered_json rows = ordered_json::array();
  for (const auto& [x, y] : function.table) rows.push_back({x, y});
  return rows;
}

bool is_table(const std::optional<MachineFunction>& function) {
  return function && !function->table.empty();
}

const char* interpolation(bool smooth) {
  return smooth ? "smooth" : "linear";
}

ordered_json equivalent_json(const MachineProblem& problem) {
  ordered_json table = ordered_json::object();
  if (problem.inertia) table["inertia"] = function_json(*problem.inertia);
  if (problem.torque) table["torque"] = function_json(*problem.torque);
  if (is_table(problem.inertia)) {
    table["interpolation"] = interpolation(problem.inertia->smooth);
  } else if (is_table(problem.torque)) {
    table["interpolation"] = interpolation(problem.torque->smooth);
  }
  return table;
}

ordered_json motor_json(const problems::Motor& motor) {
  ordered_json table = ordered_json::object();
  if (motor.line) {
    table["line"] = {{"stall_torque", motor.line->stall_torque},
                     {"no_load_speed", motor.line->no_load_speed}};
  } else if (!motor.torque.table.empty()) {
    table["table"] = function_json(motor.torque);
    table["interpolation"] = interpolation(motor.torque.smooth);
  } else {
    table["torque"] = function_json(motor.torque);
  }
  table["ratio"] = motor.ratio;
  table["efficiency"] = motor.efficiency;
  table["inertia"] = motor.inertia;
  return table;
}

ordered_json run_json(const problems::MachineRunRequest& run) {
  ordered_json table = {{"tasks", ordered_json::array()}};
  for (const auto task : run.tasks) table["tasks"].push_back(problems::to_string(task));
  table["start_deg"] = degrees(run.start_phi);
  table["start_speed"] = run.start_speed;
  if (run.time_max) table["time_max"] = *run.time_max;
  if (run.turns_max) table["turns_max"] = *run.turns_max;
  if (run.speed_end) table["speed_end"] = *run.speed_end;
  table["steps"] = run.steps;
  table["tolerance"] = run.tolerance;
  return table;
}

void add_parts(ordered_json& tables, const MachineProblem& problem) {
  const problems::AnalysisProblem& given = *problem.mechanism;
  tables["mechanism"] = mechanism_json(given.mechanism);
  tables["link"] = links_json(given);
  tables["load"] = ordered_json::array();
  for (const auto& load : given.loads) tables["load"].push_back(load_json(given, load));
  for (const auto& load : problem.loads) {
    ordered_json table = load_json(given, load.rule);
    table["value"] = function_json(load.value);
    if (is_table(load.value)) table["interpolation"] = interpolation(load.value.smooth);
    tables["load"].push_back(table);
  }
  tables["gravity"] = to_json(given.gravity);
}

}  // namespace

ordered_json Kind<MachineProblem>::to_json(const MachineProblem& problem) {
  ordered_json tables = {{"kind", "machine"}};
  if (!problem.title.empty()) tables["title"] = problem.title;
  if (problem.mechanism) add_parts(tables, problem);
  if (problem.inertia || problem.torque) tables["equivalent"] = equivalent_json(problem);
  if (problem.motor) tables["motor"] = motor_json(*problem.motor);
  if (problem.fluctuation) {
    tables["flywheel"] = {{"fluctuation", *problem.fluctuation}};
  } else if (problem.flywheel > 0) {
    tables["flywheel"] = {{"inertia", problem.flywheel}};
  }
  if (problem.brake) tables["brake"] = {{"torque", *problem.brake}};
  tables["run"] = run_json(problem.run);
  return tables;
}

ordered_json machine_mechanism_json(const MachineProblem& problem) {
  if (problem.mechanism) return mechanism_json(problem.mechanism->mechanism);
  ordered_json table = {{"type", "equivalent"}};
  table.update(equivalent_json(problem));
  return table;
}

}  // namespace cognate::app
