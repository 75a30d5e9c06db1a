/// Mechanisms with dwells from problem to designs: search, conversion to the file's units,
/// verification.

#include <algorithm>
#include <cmath>

#include "analysis/numbers/parallel.hpp"
#include "problems/dwell/search.hpp"
#include "problems/dwell/verify.hpp"
#include "problems/linkage/design_tolerances.hpp"
#include "problems/linkage/result.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/linkage/warnings.hpp"
#include "problems/search/solver_origin.hpp"
#include "problems/search/statistics.hpp"

namespace cognate::problems {
namespace {

/// Those that meet every limit, the best first; the others only where there are no such.
std::vector<Design> designs_of_dwells(const DwellProblem& problem,
                                      const std::vector<DwellMinimum>& found) {
  std::vector<Design> feasible, others;
  for (const DwellMinimum& one : found) {
    if (!std::isfinite(one.half_band)) continue;
    const DwellSpace& space = *one.space;
    auto mechanism = named(*space.topology, space.scale.out_of(space.chain, one.design.chain));
    Design design = verified(problem, *space.topology, std::move(mechanism), one.design.start);
    if (!std::isfinite(design.error.sum_of_squares)) continue;
    design.origin = search_origin(synthesis::Solver::slsqp);
    (all_satisfied(design.constraints) ? feasible : others).push_back(std::move(design));
  }
  auto& best = feasible.empty() ? others : feasible;
  std::ranges::stable_sort(best, {}, [](const Design& design) { return design.error.max; });
  const auto wanted = static_cast<std::size_t>(problem.solve.designs);
  if (best.size() > wanted) best.resize(wanted);
  return std::move(best);
}

Status status_of_dwells(const std::vector<Design>& designs, const Deadline& deadline) {
  if (deadline.reached()) {
    return deadline.interrupted() ? Status::interrupted : Status::time_limit;
  }
  if (designs.empty()) return Status::no_solution;
  return all_satisfied(designs.front().constraints) ? Status::solved : Status::infeasible;
}

/// The angle of the output in each dwell from the middle of its band there.
std::optional<ToleranceQuestion> dwell_question(const DwellProblem& problem, const Design& design) {
  constexpr int kSteps = 45;
  std::vector<double> angles;
  for (std::size_t k = 0; k + 1 < design.crank_angles.size(); k += 2) {
    for (int i = 0; i <= kSteps; ++i) {
      angles.push_back(design.crank_angles[k] + problem.dwells[k / 2].over * i / kSteps);
    }
  }
  auto [question, kept] = question_at(design.mechanism, angles);
  const auto first = point_response(design.mechanism, problem.output[0]);
  const auto second = point_response(design.mechanism, problem.output[1]);
  if (!first || !second || kept.size() != angles.size()) return std::nullopt;
  const int body = design.mechanism.points[second->index].at.body;
  ToleranceQuantity output{.name = "output", .judged = true};
  output.response = {.type = ResponseType::angle, .index = static_cast<std::size_t>(body)};
  ChangedMechanism<double> nominal({design.mechanism.mechanism, {}});
  std::vector<Vec2d> way;
  for (const Station& station : question.stations) {
    nominal.move_to(station);
    way.push_back(nominal.value(output.response));
  }
  for (std::size_t begin = 0; begin < way.size(); begin += kSteps + 1) {
    double least = 0, greatest = 0;
    for (std::size_t i = 0; i <= kSteps; ++i) {
      const double angle = deviation(ResponseType::angle, way[begin + i], way[begin]).x;
      least = std::min(least, angle);
      greatest = std::max(greatest, angle);
      output.offset.push_back(angle);
    }
    for (std::size_t i = 0; i <= kSteps; ++i) {
      output.offset[begin + i] -= 0.5 * (least + greatest);
    }
  }
  question.quantities.push_back(std::move(output));
  add_transmissions(design.mechanism, question);
  return std::move(question);
}

void add_dwell_tolerances(const DwellProblem& problem, const Run& run, Result& result) {
  add_tolerances(
      problem.tolerances, problem.length_unit, run,
      [&](const Design& design) { return dwell_question(problem, design); }, result);
}

}  // namespace

Result solve(const DwellProblem& given, const Run& run) {
  const auto valid = KindTraits<DwellProblem>::checked(given);
  if (!valid) return refused<Result>(valid.error());
  const DwellProblem& problem = *valid;
  const Deadline deadline(run);
  std::vector<DwellSpace> spaces;
  for (const Topology& topology : problem.topologies) spaces.emplace_back(problem, topology);
  Result result;
  const DwellSearchResult found = search_dwells(spaces, problem.solve, run, deadline, result.work);
  result.designs = designs_of_dwells(problem, found.designs);
  result.status = status_of_dwells(result.designs, deadline);
  result.quantities = quantities(found.statistics);
  add_warnings(std::nullopt, problem.warnings, result);
  if (result.designs.empty()) {
    result.notes.push_back(
        "No mechanism was found that is assembled over the whole turn within the limits; wider "
        "limits or more starts may help.");
  }
  add_dwell_tolerances(problem, run, result);
  result.work.threads = thread_count(run.threads);
  result.work.seconds = deadline.spent();
  return result;
}

}  // namespace cognate::problems
