#include "app/documents/problem_tables.hpp"
#include "problems/basics/names.hpp"

namespace cognate::app {

using nlohmann::ordered_json;

ordered_json tables_of(const problems::QuickReturnProblem& problem) {
  ordered_json tables = document("quick-return", problem.title);
  tables["target"]["time_ratio"] = problem.time_ratio;
  ordered_json& mechanism = tables["mechanism"];
  mechanism["type"] = problems::to_string(problem.type);
  set(mechanism, "crank", problem.given.crank);
  set(mechanism, "coupler", problem.given.coupler);
  set(mechanism, "rocker", problem.given.rocker);
  set(mechanism, "frame", problem.given.frame);
  set_deg(mechanism, "swing_deg", problem.swing);
  set(mechanism, "stroke", problem.stroke);
  set(mechanism, "offset", problem.offset);
  set(mechanism, "rod", problem.rod);
  set(mechanism, "ram_height", problem.ram_height);
  if (problem.crank_pivot_line) {
    const auto& [a, b, c] = *problem.crank_pivot_line;
    mechanism["crank_pivot_line"] = {a, b, c};
  }
  const bool four_bar = problem.type == problems::QuickReturnType::four_bar;
  if (four_bar) tables["bounds"] = bounds_table(problem.bounds);
  tables["constraints"] =
      four_bar ? constraints_table(problem.constraints) : ordered_json::object();
  set_deg(tables["constraints"], "pressure_angle_deg_max", problem.pressure_angle_max);
  tables["solve"] = solve_table(problem.solve);
  return tables;
}

}  // namespace cognate::app
