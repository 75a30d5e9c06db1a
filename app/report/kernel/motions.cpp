/// @file The search for guided bodies in a page.
#include <nlohmann/json.hpp>
#include <vector>

#include "app/report/kernel/sketched.hpp"
#include "problems/guidance/designs.hpp"
#include "problems/guidance/problem.hpp"
#include "problems/guidance/scale.hpp"
#include "problems/linkage/cycle/read_cycle.hpp"
#include "problems/linkage/read_constraints.hpp"

namespace cognate::page {
namespace {

using problems::MotionProblem;

/// Poses that a four-bar comes as near to as can be, with what the file format has for limits.
std::size_t read_poses(problems::reading::LinkageTables& tables, MotionProblem& problem) {
  using namespace problems::reading;
  auto& [target, mechanism, bounds, constraints, solve] = tables;
  problem.method = problems::MotionMethod::least_squares;
  problem.dyads = {synthesis::DyadKind::rr};
  target.know({"method"});
  mechanism.know({"dyads"});
  require_target(target, "poses");
  const auto rows = target.each_row("poses", 3, kNumber, "[x, y, angle_deg]",
                                    {.min = 2, .max = kMostTargets, .of = "poses"});
  for (const auto& row : all_or_none(rows).value_or(std::vector<std::vector<double>>{})) {
    problem.poses.push_back({{row[0], row[1]}, radians(row[2])});
  }
  const auto weight = target.number("angle_weight", kLinkLength);
  if (!problem.poses.empty()) {
    problem.angle_weight = weight.value_or(problems::natural_angle_weight(problem.poses));
  }
  read_length_bounds(bounds, problem.bounds);
  problem.bounds.pivot_a = bounds.box("pivot_a");
  problem.bounds.pivot_d = bounds.box("pivot_d");
  read_link_constraints(constraints, length_limits({}, problem.bounds), problem.constraints);
  read_clearances(constraints, {}, problem.constraints);
  problem.solve = read_solve(solve, problem.constraints, false);
  return problem.poses.size();
}

std::vector<problems::Design> solved(const MotionProblem& problem, const problems::Run& run) {
  const problems::Deadline none(run);
  problems::Work work;
  problems::MotionDesigns found(problem, problems::MotionScale(problem).size());
  add_minima(problem, problem.solve.starts, run, none, found, work);
  return found.any_feasible() ? found.take() : std::vector<problems::Design>{};
}

}  // namespace

nlohmann::ordered_json sketched_motions(const SketchQuestion& question) {
  return answered<MotionProblem>(question, read_poses, [](const auto& problem, const auto& run) {
    return solved(problem, run);
  });
}

}  // namespace cognate::page
