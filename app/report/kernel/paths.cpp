/// @file The search for paths in a page.
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "app/report/kernel/sketched.hpp"
#include "problems/linkage/cycle/read_cycle.hpp"
#include "problems/linkage/read_constraints.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/path/explorer.hpp"
#include "problems/path/found.hpp"
#include "problems/path/problem.hpp"
#include "problems/path/scale.hpp"
#include "problems/path/search.hpp"

namespace cognate::page {
namespace {

using problems::Design;
using problems::PathProblem;

/// As far as a picture shows: steps of each start that goes on, and when two are one design.
constexpr double kTolerance = 1e-10, kSame = 1e-4;
constexpr int kIterations = 100;
/// So many starts go on beyond the designs wanted.
constexpr std::size_t kMore = 9;

/// Points to be met in any timing, with what the file format has for limits.
std::size_t read_points(problems::reading::LinkageTables& tables, PathProblem& problem) {
  using namespace problems::reading;
  auto& [target, mechanism, bounds, constraints, solve] = tables;
  target.know({"timing", "order"});
  require_target(target, "points");
  const auto points =
      target.twos("points", kNumber, "[x, y]", {.min = 3, .max = kMostTargets, .of = "points"});
  for (const Two& point : points.value_or(std::vector<Two>{})) {
    problem.points.push_back({point[0], point[1]});
  }
  problem.weights.assign(problem.points.size(), 1);
  read_given_links(mechanism, problem.given);
  read_given_places(mechanism, problem.given);
  read_length_bounds(bounds, problem.bounds);
  read_place_bounds(bounds, problem.bounds);
  check_given(mechanism, problem.given, problem.bounds);
  read_link_constraints(constraints, length_limits(problem.given, problem.bounds),
                        problem.constraints);
  read_pivot_region(constraints, problem.given, problem.constraints);
  read_clearances(constraints, {}, problem.constraints);
  problem.solve = read_solve(solve, problem.constraints, false);
  return problem.points.size();
}

Design design_of(const PathProblem& problem, const FourBar& linkage,
                 std::vector<double> crank_angles) {
  Design design;
  design.mechanism.description = linkage;
  design.error = problems::path_error(linkage, problem.points, crank_angles);
  design.metrics = problems::design_metrics(linkage, crank_angles, {problem.order, false});
  design.crank_angles = std::move(crank_angles);
  return design;
}

/// Minima of a scaled problem near the best starts, as many as are requested and some more, which
/// may prove to be the same.
std::vector<problems::PathFound> minima(const PathProblem& scaled, const problems::Run& run) {
  const problems::Deadline none(run);
  const std::size_t kept = kMore + static_cast<std::size_t>(scaled.solve.designs);
  problems::Work work;
  synthesis::MultiStart<problems::PathRules> search({}, {1, none});
  search.all() =
      problems::explore_paths(scaled, {scaled.solve.starts, kept, run}, none, work).minima;
  search.keep(kept);
  search.refine({0, 1}, [&](problems::PathFound& found) {
    auto refined = found;
    refined.minimum.solution = problems::minimise(scaled, refined, synthesis::Solver::gauss_newton,
                                                  {.tolerance = kTolerance,
                                                   .feasibility = problems::kPathFeasibility,
                                                   .max_iterations = kIterations});
    if (!problems::is_better(found, refined)) found = std::move(refined);
  });
  search.merge(kSame);
  return std::move(search.all());
}

std::vector<Design> solved(const PathProblem& problem, problems::Run run) {
  const problems::PathScale scale(problem);
  const PathProblem scaled = scale.into(problem);
  for (Design& design : run.known) {
    design.mechanism.description = scale.into(four_bar(design));
  }
  std::vector<Design> designs;
  for (const problems::PathFound& found : minima(scaled, run)) {
    const problems::PathMinimum& minimum = found.minimum;
    if (found.strays || minimum.solution.violation > problems::kPathFeasibility) continue;
    if (std::ssize(designs) == problem.solve.designs) break;
    const auto model = problems::model_of(scaled, minimum);
    designs.push_back(design_of(problem, scale.out_of(model.linkage(minimum.solution.x)),
                                model.crank_angles(minimum.solution.x)));
  }
  return designs;
}

}  // namespace

nlohmann::ordered_json sketched_paths(const SketchQuestion& question) {
  return answered<PathProblem>(question, read_points, [](const auto& problem, const auto& run) {
    return solved(problem, run);
  });
}

}  // namespace cognate::page
