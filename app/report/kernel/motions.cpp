/// @file The search for guided bodies in a page.
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "app/report/kernel/answer.hpp"
#include "app/report/kernel/sketched.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/guidance/designs.hpp"
#include "problems/guidance/problem.hpp"
#include "problems/guidance/scale.hpp"
#include "problems/linkage/read_constraints.hpp"
#include "problems/linkage/read_linkage.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::page {
namespace {

using json = nlohmann::ordered_json;
using problems::Design;
using problems::MotionProblem;

/// Poses that a four-bar comes as near to as can be, with what the file format has for limits; or
/// what is wrong with them.
Sketched<MotionProblem> asked_motion(const problems::reading::Table& document,
                                     problems::reading::FaultList& faults) {
  using namespace problems::reading;
  TableReader reader(document, faults);
  reader.know({"kind"});
  LinkageTables tables(reader);
  auto& [target, mechanism, bounds, constraints, solve] = tables;
  MotionProblem problem;
  problem.method = problems::MotionMethod::least_squares;
  problem.dyads = {synthesis::DyadKind::rr};
  target.know({"method"});
  mechanism.know({"dyads"});
  if (!has_target(target, "poses")) return {};
  const auto rows = target.each_row("poses", 3, kNumber, "[x, y, angle_deg]",
                                    {.min = 2, .max = kMostTargets, .of = "poses"});
  for (const auto& row : all_or_none(rows).value_or(std::vector<std::vector<double>>{})) {
    problem.poses.push_back({{row[0], row[1]}, problems::reading::radians(row[2])});
  }
  const auto weight = target.number("angle_weight", kLinkLength);
  if (!problem.poses.empty()) {
    problem.angle_weight = weight.value_or(problems::natural_angle_weight(problem.poses));
  }
  read_length_bounds(bounds, problem.bounds);
  problem.bounds.pivot_a = bounds.box("pivot_a");
  problem.bounds.pivot_d = bounds.box("pivot_d");
  read_link_constraints(constraints, length_limits({}, problem.bounds), problem.constraints);
  problem.solve = read_solve(solve, problem.constraints, false);
  tables.finish();
  auto known = read_known(reader, problem.poses.size());
  reader.finish();
  return {std::move(problem), std::move(known)};
}

json solved(const MotionProblem& problem, const problems::Run& run) {
  const problems::Deadline none(run);
  problems::Work work;
  problems::MotionDesigns found(problem, problems::MotionScale(problem).size());
  add_minima(problem, problem.solve.starts, run, none, found, work);
  const bool feasible = found.any_feasible();
  json designs = json::array();
  for (const Design& design : feasible ? found.take() : std::vector<Design>{}) {
    designs.push_back(sketched(design));
  }
  const bool none_closes = !feasible && found.ranked().empty();
  const char* status = feasible ? "solved" : none_closes ? "no solution" : "infeasible";
  return {{"status", status}, {"designs", std::move(designs)}};
}

}  // namespace

json sketched_motions(const SketchQuestion& question) {
  problems::reading::FaultList faults;
  const auto [problem, known] = asked_motion(question.document, faults);
  if (!faults.empty()) return faults_json(std::move(faults));
  return solved(problem, run_of(question, known));
}

}  // namespace cognate::page
