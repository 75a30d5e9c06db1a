/// Function generation from problem to designs: exact synthesis, or search and verification.
#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "analysis/numbers/parallel.hpp"
#include "problems/function/certificate.hpp"
#include "problems/function/designs.hpp"
#include "problems/function/error.hpp"
#include "problems/function/exact.hpp"
#include "problems/function/notes.hpp"
#include "problems/function/search.hpp"
#include "problems/linkage/certifying.hpp"
#include "problems/linkage/cycle_metrics.hpp"
#include "problems/linkage/deadline.hpp"
#include "problems/linkage/error_limit.hpp"
#include "problems/linkage/oddities.hpp"
#include "problems/linkage/refused.hpp"
#include "problems/search/infeasibility.hpp"
#include "problems/search/objectives.hpp"
#include "problems/search/solver_origin.hpp"

namespace cognate::problems {
namespace {

Status status(const Result& result, const Deadline& deadline, bool ended_early) {
  if (ended_early) return deadline.interrupted() ? Status::interrupted : Status::time_limit;
  if (result.designs.empty()) return Status::no_solution;
  const auto& constraints = result.designs.front().constraints;
  const bool sound = std::all_of(constraints.begin(), constraints.end(),
                                 [](const ConstraintCheck& check) { return check.satisfied; });
  return sound ? Status::solved : Status::infeasible;
}

/// Where a design came from, then the solvers that refined it.
std::string origin(StartOrigin start, synthesis::Solver finisher) {
  const std::string refined = search_origin(finisher).substr(std::string_view("search").size());
  switch (start) {
    case StartOrigin::overlay:
      return "exact:overlay" + refined;
    case StartOrigin::five_points:
      return "exact:freudenstein-5" + refined;
    case StartOrigin::search:
      break;
  }
  return "search" + refined;
}

Result solve_by_search(const FunctionProblem& problem, const Run& run, const Deadline& deadline) {
  Result result;
  const FunctionSamples wanted = function_samples(problem);
  const auto found = search_functions(problem, wanted, run, deadline, result.work);
  result.quantities = quantities(found.statistics);
  const bool ended_early = deadline.reached();
  std::vector<Design> designs;
  for (const auto& [minimum, from] : found.minima) {
    Design design = function_design(problem, wanted, minimum, positions_of(minimum, wanted.samples),
                                    origin(from, finisher_of(problem)));
    check_error(problem, design);
    if (std::isfinite(design.error.sum_of_squares)) designs.push_back(std::move(design));
  }
  // By a loss the search knows which is best; the design's own error is that of least squares.
  const bool by_loss = problem.solve.loss != synthesis::Loss::none;
  result.designs =
      best_designs(std::move(designs), by_loss ? std::nullopt : std::optional(problem.objective),
                   problem.solve.designs);
  result.status = status(result, deadline, ended_early);
  if (result.status == Status::no_solution) {
    result.notes.push_back(
        "No four-bar was found that closes over the whole range; wider bounds, free start angles "
        "or more starts may help.");
  }
  return result;
}

void add_certificate(const FunctionProblem& problem, const Run& run, const Deadline& deadline,
                     Result& result) {
  if (result.status != Status::solved) {
    result.notes.emplace_back(kNothingToCertify);
    return;
  }
  const double best = result.designs.front().error.sum_of_squares;
  result.certificate = certify(problem, function_samples(problem), best, run, deadline);
}

}  // namespace

Result solve(const FunctionProblem& given, const Run& run) {
  const auto valid = KindTraits<FunctionProblem>::checked(given);
  if (!valid) return refused<Result>(valid.error());
  const FunctionProblem& problem = *valid;
  const Deadline deadline(run);
  const bool exact = problem.objective == FunctionObjective::exact;
  const auto solve_one = [&](const FunctionProblem& one, const Run& own) {
    return solve_by_search(one, own, deadline);
  };
  Result result = exact ? solve_exactly(problem, deadline)
                        : solve_objectives(problem, before_certificate(run, problem.solve),
                                           deadline, solve_one);
  if (!exact) {
    Run silent = run;
    silent.progress = nullptr;
    const auto solve_once = [&](const FunctionProblem& other) {
      return solve_by_search(other, silent, deadline);
    };
    add_infeasibility(problem, deadline, solve_once, result);
    if (problem.solve.certify) add_certificate(problem, run, deadline, result);
  }
  note_motions(problem, function_samples(problem), result);
  note_oddities(std::nullopt, result, kDeadTransmission);
  result.work.skipped = skipped_evaluations(problem.constraints);
  if (exact) result.work.skipped.insert(result.work.skipped.begin(), {"search", "gradients"});
  result.work.threads = exact ? 1 : thread_count(run.threads);
  result.work.seconds = deadline.spent();
  return result;
}

}  // namespace cognate::problems
