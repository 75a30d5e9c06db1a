#include "app/documents/problem_tables.hpp"
#include "app/kinds/straight_line/kind.hpp"
#include "problems/basics/names.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;
using problems::CrankArrangement;
using problems::StraightLineProblem;

ordered_json slider_crank_table(const StraightLineProblem& problem) {
  ordered_json table{{"type", "slider-crank"}};
  set_json(table, "pivot", problem.given.pivot_a);
  set(table, "crank", problem.given.crank);
  set(table, "coupler", problem.given.coupler);
  table["offset"] = problem.slider->offset;
  table["direction_deg"] = degrees(problem.slider->direction);
  if (problem.given.assembly) table["assembly"] = problems::to_string(*problem.given.assembly);
  return table;
}

ordered_json four_bar_table(const StraightLineProblem& problem) {
  ordered_json table = mechanism_table(problem.given);
  table["cranks"] = problems::kCrankArrangements[static_cast<std::size_t>(problem.cranks)];
  if (problem.cranks == CrankArrangement::parallel) {
    table["sides"] = problems::kCrankSides[static_cast<std::size_t>(problem.sides)];
    table["coupler_angle_deg"] = degrees(problem.coupler_angle);
  }
  return table;
}

ordered_json searched_mechanism(const StraightLineProblem& problem) {
  const problems::Given& given = problem.given;
  if (problem.type == problems::MechanismType::four_bar) return mechanism_table(given);
  ordered_json table{{"type", "slider-crank"}};
  set_json(table, "pivot", given.pivot_a);
  set(table, "crank", given.crank);
  set(table, "coupler", given.coupler);
  set(table, "offset", problem.slider_offset);
  set_deg(table, "direction_deg", given.frame_angle);
  set_json(table, "coupler_point", given.coupler_point);
  if (given.assembly) table["assembly"] = problems::to_string(*given.assembly);
  return table;
}

ordered_json search_tables(const StraightLineProblem& problem) {
  ordered_json tables = document("straight-line", problem.title);
  auto& target = tables["target"];
  target = ordered_json::object();
  set(target, "length", problem.goal->length);
  set(target, "deviation", problem.goal->deviation);
  set(target, "deviation_relative", problem.goal->deviation_relative);
  set_deg(target, "direction_deg", problem.goal->direction);
  tables["mechanism"] = searched_mechanism(problem);
  tables["bounds"] = bounds_table(problem.bounds);
  auto& constraints = tables["constraints"];
  constraints = constraints_table(problem.constraints);
  set_deg(constraints, "crank_range_deg", problem.segment.crank_range);
  set(constraints, "size_over_length_max", problem.segment.size_over_length_max);
  set(constraints, "speed_variation_max", problem.segment.speed_variation_max);
  tables["solve"] = solve_table(problem.solve);
  return tables;
}

}  // namespace

ordered_json Kind<problems::StraightLineProblem>::to_json(
    const problems::StraightLineProblem& problem) {
  if (problem.goal) return search_tables(problem);
  ordered_json tables = document("straight-line", problem.title);
  tables["target"] = {{"method", "exact"}, {"contact", problem.contact}};
  auto& mechanism = tables["mechanism"];
  mechanism = problem.slider ? slider_crank_table(problem) : four_bar_table(problem);
  set_deg(mechanism, "crank_deg", problem.crank_angle);
  tables["constraints"] = constraints_table(problem.constraints);
  tables["solve"] = {{"designs", problem.solve.designs}};
  return tables;
}

}  // namespace cognate::app
