#include "app/documents/cycle_tables.hpp"
#include "app/documents/problem_tables.hpp"
#include "app/kinds/guidance/kind.hpp"
#include "problems/basics/names.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;

ordered_json points(const std::vector<Vec2d>& all) {
  ordered_json rows = ordered_json::array();
  for (const Vec2d& point : all) rows.push_back(to_json(point));
  return rows;
}

ordered_json target(const problems::MotionProblem& problem) {
  ordered_json table = ordered_json::object();
  table["method"] = problems::to_string(problem.method);
  if (problem.method == problems::MotionMethod::least_squares) {
    table["angle_weight"] = problem.angle_weight;
  }
  if (!problem.segments.empty()) {
    auto& segments = table["segments"] = ordered_json::array();
    for (const auto& [first, second] : problem.segments)
      segments.push_back(points({first, second}));
    return table;
  }
  auto& poses = table["poses"] = ordered_json::array();
  for (const auto& pose : problem.poses) {
    poses.push_back(ordered_json::array({pose.at.x, pose.at.y, degrees(pose.angle)}));
  }
  return table;
}

ordered_json mechanism(const problems::MotionProblem& problem) {
  ordered_json table = ordered_json::object();
  if (!problem.fixed_pivots.empty()) table["fixed_pivots"] = points(problem.fixed_pivots);
  if (!problem.moving_pivots.empty()) table["moving_pivots"] = points(problem.moving_pivots);
  if (problem.fixed_pivot_line) table["fixed_pivot_line"] = *problem.fixed_pivot_line;
  set(table, "crank", problem.crank);
  set(table, "rocker", problem.rocker);
  auto& dyads = table["dyads"] = ordered_json::array();
  for (const auto kind : problem.dyads) dyads.push_back(problems::to_string(kind));
  return table;
}

}  // namespace

ordered_json Kind<problems::MotionProblem>::to_json(const problems::MotionProblem& problem) {
  ordered_json tables = document("motion-generation", problem.title);
  tables["target"] = target(problem);
  tables["mechanism"] = mechanism(problem);
  auto& bounds = tables["bounds"] = bounds_table(problem.bounds);
  set_json(bounds, "moving_pivot_a", problem.moving_bounds[0]);
  set_json(bounds, "moving_pivot_d", problem.moving_bounds[1]);
  tables["constraints"] = constraints_table(problem.constraints);
  add_operation(problem.constraints, tables);
  tables["solve"] = solve_table(problem.solve);
  return tables;
}

}  // namespace cognate::app
