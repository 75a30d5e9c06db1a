#include "app/problem_tables.hpp"
#include "problems/names.hpp"

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

}  // namespace

ordered_json tables_of(const StraightLineProblem& problem) {
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
