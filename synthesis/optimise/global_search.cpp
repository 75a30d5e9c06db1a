#include <algorithm>
#include <chrono>
#include <limits>
#include <utility>

#include "synthesis/optimise/nlopt_run.hpp"

namespace cognate::synthesis {
namespace {

using Known = NloptMethod::Constraints;

/// A bound farther than this many scales from the start is as good as none.
constexpr double kFarthestBound = 100;
/// Half the side, in scales, of the box about the start where there is no bound.
constexpr double kReach = 10;
constexpr int kEvaluationsOfUnknown = 1000;
/// A global search takes points that miss constraints by less for feasible: on an equality it would
/// never stand else. The descent that follows mends the rest.
constexpr double kNearlyFeasible = 1e-3;

NloptMethod method_of(Solver solver, const DenseModel& model) {
  switch (solver) {
    case Solver::ags:
      return {NLOPT_GN_AGS, false, Known::few_inequalities, true};
    case Solver::isres:
      return {NLOPT_GN_ISRES, false, Known::all, true};
    case Solver::mlsl:
      // max |r| has kinks, which stop a descent along gradients.
      return model.minimax()
                 ? NloptMethod{NLOPT_G_MLSL_LDS, false, Known::none, true, NLOPT_LN_SBPLX}
                 : NloptMethod{NLOPT_G_MLSL_LDS, true, Known::none, true, NLOPT_LD_SLSQP};
    // Gablonsky's own code takes inequalities, but its time grows with the square of the number of
    // points that violate them.
    case Solver::direct:
      return {NLOPT_GN_DIRECT_L, false, Known::none, true};
    default:
      return {NLOPT_GN_CRS2_LM, false, Known::none, true};
  }
}

/// The bounds of the program, and a box about its start where they are missing or far.
NloptLimits box(const Program& program) {
  NloptLimits limits{program.lower(), program.upper()};
  for (Eigen::Index k = 0; k < program.size(); ++k) {
    const double start = program.start()[k];
    if (!(start - limits.lower[k] <= kFarthestBound)) limits.lower[k] = start - kReach;
    if (!(limits.upper[k] - start <= kFarthestBound)) limits.upper[k] = start + kReach;
  }
  return limits;
}

Outcome run_search(Solver solver, DenseModel& model, const Options& options) {
  Program program(model, Minimax::direct);
  NloptLimits limits = box(program);
  constexpr std::uint64_t kMost = std::numeric_limits<int>::max();
  const std::uint64_t by_size = kEvaluationsOfUnknown * (std::uint64_t(program.size()) + 1);
  const std::uint64_t wanted =
      options.search_evaluations > 0 ? options.search_evaluations : by_size;
  limits.evaluations = static_cast<int>(std::min(wanted, kMost));
  return run_nlopt(method_of(solver, model), program, limits, options);
}

bool better(const Solution& a, const Solution& b, double feasibility) {
  const bool a_feasible = a.violation <= feasibility, b_feasible = b.violation <= feasibility;
  if (a_feasible != b_feasible) return a_feasible;
  return a_feasible ? a.objective < b.objective : a.violation < b.violation;
}

}  // namespace

Solution search_globally(Solver solver, const Model& model, std::span<const double> start,
                         const Options& options) {
  const auto begin = std::chrono::steady_clock::now();
  Options coarse = options;
  coarse.feasibility = std::max(options.feasibility, kNearlyFeasible);
  DenseModel dense(model, start, coarse);
  if (const auto stop = dense.stop_at_start()) return dense.finish(*stop, 0, {});
  const Outcome outcome = run_search(solver, dense, coarse);
  const Solution found = dense.finish(outcome.stop, 0, {});
  Solution before = DenseModel(model, start, options).finish(outcome.stop, 0, {});
  if (found.stop != Stop::converged && found.stop != Stop::infeasible) {
    return better(before, found, options.feasibility) ? before : found;
  }

  Solution total;
  const auto descend = [&](std::span<const double> from) {
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
    Options left = options;
    left.time_limit -= spent.count();
    const bool minimax = model.objective() == Objective::max_abs;
    Solution local = solve(minimax ? Solver::slsqp : Solver::gauss_newton, model, from, left);
    total.iterations += local.iterations;
    total.evaluations += local.evaluations;
    total.gradients += local.gradients;
    return local;
  };
  Solution best = descend(found.x);
  const auto improve = [&](std::span<const double> from) {
    Solution next = descend(from);
    if (better(next, best, options.feasibility)) best = std::move(next);
  };
  if (model.constraint_count() > 0) improve(dense.variables_at(outcome.end));
  if (better(before, best, options.feasibility)) improve(start);
  if (better(before, best, options.feasibility)) best = before;
  best.iterations = total.iterations;
  best.evaluations = total.evaluations + found.evaluations + before.evaluations;
  best.gradients = total.gradients + found.gradients;
  return best;
}

}  // namespace cognate::synthesis
