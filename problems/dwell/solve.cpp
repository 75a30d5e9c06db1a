/// Mechanisms with dwells from problem to designs: search, conversion to the file's units,
/// verification.

#include <algorithm>
#include <cmath>

#include "analysis/numbers/parallel.hpp"
#include "problems/dwell/search.hpp"
#include "problems/dwell/verify.hpp"
#include "problems/linkage/result.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/linkage/warnings.hpp"
#include "problems/search/solver_origin.hpp"
#include "problems/search/statistics.hpp"

namespace cognate::problems {
namespace {

/// Those that meet every limit, the best first; the others only where there are no such.
std::vector<Design> designs_of_dwells(const DwellProblem& problem,
                                      const std::vector<FoundDwell>& found) {
  std::vector<Design> feasible, others;
  for (const FoundDwell& one : found) {
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
  result.work.threads = thread_count(run.threads);
  result.work.seconds = deadline.spent();
  return result;
}

}  // namespace cognate::problems
