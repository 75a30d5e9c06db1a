#include "app/documents/cycle_tables.hpp"
#include "app/documents/json_values.hpp"
#include "app/documents/problem_tables.hpp"
#include "app/kinds/function/kind.hpp"
#include "problems/basics/names.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;
using problems::to_string;

ordered_json pairs(const std::vector<std::pair<double, double>>& all) {
  ordered_json rows = ordered_json::array();
  for (const auto& [x, y] : all) rows.push_back(ordered_json::array({x, y}));
  return rows;
}

ordered_json pairs_deg(const problems::AnglePairs& all) {
  ordered_json rows = ordered_json::array();
  for (const auto& [x, y] : all) rows.push_back(ordered_json::array({degrees(x), degrees(y)}));
  return rows;
}

bool is_slider(const problems::FunctionProblem& problem) {
  return problem.type == problems::MechanismType::slider_crank;
}

/// `[target]` of a function; a slider's output is a displacement.
ordered_json target_values(const problems::FunctionOfX& function, bool slider) {
  ordered_json table = ordered_json::object();
  if (function.text.empty()) {
    table["table"] = pairs(function.table);
  } else {
    table["function"] = function.text;
  }
  table["domain"] = to_json(function.domain);
  set_deg(table, "input_range_deg", function.input_range);
  if (slider) {
    set(table, "output_range", function.output_range);
  } else {
    set_deg(table, "output_range_deg", function.output_range);
  }
  if (!function.input_range && !function.output_range) table["relation"] = "angles";
  return table;
}

ordered_json target_values(const problems::AnglePairs& given, bool slider) {
  if (!slider) return {{"pairs_deg", pairs_deg(given)}};
  ordered_json rows = ordered_json::array();
  for (const auto& [input, output] : given) rows.push_back({degrees(input), output});
  return {{"pairs", rows}};
}

ordered_json target(const problems::FunctionProblem& problem) {
  const bool slider = is_slider(problem);
  ordered_json table =
      std::visit([=](const auto& values) { return target_values(values, slider); }, problem.target);
  if (problem.objective == problems::FunctionObjective::exact) {
    table["precision_points"] = problem.precision_points;
  } else {
    table["objective"] = to_string(problem.objective);
  }
  if (!problem.at.empty()) table["at"] = problem.at;
  if (problem.spacing != problems::PointSpacing::chebyshev) {
    table["spacing"] = to_string(problem.spacing);
  }
  if (!problem.multiplicity.empty()) table["multiplicity"] = problem.multiplicity;
  if (!problem.derivatives.empty()) table["derivatives"] = problem.derivatives;
  if (!problem.sample_at.empty()) table["sample_at"] = problem.sample_at;
  return table;
}

ordered_json mechanism(const problems::FunctionProblem& problem) {
  ordered_json table = mechanism_table(problem.given);
  table["type"] = to_string(problem.type);
  const bool exact = problem.objective == problems::FunctionObjective::exact;
  const bool given = problem.input_start && problem.output_start;
  // A start that an exact synthesis leaves free is said to be: three pairs alone have none.
  if (problem.start != problems::FunctionStart::free || (exact && !given)) {
    table["start"] = to_string(problem.start);
  }
  set_deg(table, "input_start_deg", problem.input_start);
  if (is_slider(problem)) {
    set(table, "output_start", problem.output_start);
  } else {
    set_deg(table, "output_start_deg", problem.output_start);
  }
  return table;
}

ordered_json bounds(const problems::FunctionProblem& problem) {
  ordered_json table = bounds_table(problem.bounds);
  set_deg(table, "input_start_deg", problem.input_start_bounds);
  if (is_slider(problem)) {
    set_json(table, "output_start", problem.output_start_bounds);
  } else {
    set_deg(table, "output_start_deg", problem.output_start_bounds);
  }
  return table;
}

}  // namespace

ordered_json Kind<problems::FunctionProblem>::to_json(const problems::FunctionProblem& problem) {
  ordered_json tables = document("function-generation", problem.title);
  tables["target"] = target(problem);
  tables["mechanism"] = mechanism(problem);
  tables["bounds"] = bounds(problem);
  tables["constraints"] = constraints_table(problem.constraints);
  add_operation(problem.constraints, tables);
  tables["solve"] = solve_table(problem.solve);
  if (problem.best_by) tables["solve"]["best_by"] = to_string(*problem.best_by);
  return tables;
}

}  // namespace cognate::app
