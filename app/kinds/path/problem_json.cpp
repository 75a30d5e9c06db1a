#include "app/documents/cycle_tables.hpp"
#include "app/documents/json_values.hpp"
#include "app/documents/problem_tables.hpp"
#include "app/kinds/path/kind.hpp"
#include "problems/basics/names.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;
using problems::to_string;

ordered_json crank_angles(const problems::PathProblem& problem) {
  ordered_json all = ordered_json::array();
  for (std::size_t j = 0; j < problem.points.size(); ++j) {
    if (problem.is_timed(j)) {
      all.push_back(degrees(problem.crank_angles[j]));
    } else {
      all.push_back(problems::kFreeAngle);
    }
  }
  return all;
}

/// `[target]` of a closed curve; of a drawing the path data that it held.
ordered_json target_curve(const problems::PathProblem& problem) {
  const problems::TargetCurve& curve = *problem.curve;
  ordered_json table = ordered_json::object();
  if (curve.svg_path.empty()) {
    for (const Vec2d& vertex : curve.curve.vertices()) table["curve"].push_back(to_json(vertex));
  } else {
    table["svg_path"] = curve.svg_path;
  }
  table["samples"] = problem.points.size();
  table["place"] = to_string(curve.place);
  table["crank_sense"] = to_string(problem.crank_sense);
  return table;
}

ordered_json target(const problems::PathProblem& problem) {
  if (problem.curve) return target_curve(problem);
  ordered_json table = ordered_json::object();
  const std::size_t poses = problem.pose_angles.size();
  for (std::size_t i = 0; i < poses; ++i) {
    const auto& [x, y] = problem.points[i];
    table["poses"].push_back(ordered_json::array({x, y, degrees(problem.pose_angles[i])}));
  }
  if (poses == 0) table["points"] = ordered_json::array();
  for (std::size_t i = poses; i < problem.points.size(); ++i) {
    table["points"].push_back(to_json(problem.points[i]));
  }
  if (problem.method == problems::PathMethod::exact) table["method"] = to_string(problem.method);
  table["timing"] = to_string(problem.timing);
  if (problem.timing == problems::Timing::free) {
    table["order"] = to_string(problem.order);
  } else {
    table["crank_deg"] = crank_angles(problem);
    table["crank_reference"] = to_string(problem.crank_reference);
  }
  table["crank_sense"] = to_string(problem.crank_sense);
  if (problem.method == problems::PathMethod::least_squares) table["weights"] = problem.weights;
  return table;
}

}  // namespace

ordered_json Kind<problems::PathProblem>::to_json(const problems::PathProblem& problem) {
  ordered_json tables = document("path-generation", problem.title);
  tables["target"] = target(problem);
  tables["mechanism"] = mechanism_table(problem.given);
  tables["bounds"] = bounds_table(problem.bounds);
  tables["constraints"] = constraints_table(problem.constraints);
  add_operation(problem.constraints, tables);
  if (problem.curve) tables["constraints"]["no_extra_loop"] = problem.constraints.no_extra_loop;
  tables["solve"] = solve_table(problem.solve);
  if (problem.atlas) tables["solve"]["atlas"] = problem.atlas->name;
  return tables;
}

}  // namespace cognate::app
