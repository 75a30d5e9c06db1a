#include "synthesis/optimise/solver.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "synthesis/optimise/foreign_solvers.hpp"
#include "synthesis/optimise/gauss_newton.hpp"

namespace cognate::synthesis {
namespace {

Outcome minimise(Solver solver, DenseModel& model, const Options& options) {
  switch (solver) {
    case Solver::ceres:
      return minimise_with_ceres(model, options);
    case Solver::ipopt:
      return minimise_with_ipopt(model, options);
    default:
      return minimise_with_nlopt(solver, model, options);
  }
}

Solution solve_dense(Solver solver, const Model& model, std::span<const double> start,
                     const Options& options) {
  DenseModel dense(model, start, options);
  if (const auto stop = dense.stop_at_start()) return dense.finish(*stop, 0, {});
  Outcome outcome = minimise(solver, dense, options);
  return dense.finish(outcome.stop, outcome.iterations, std::move(outcome.multipliers));
}

}  // namespace

Solution solve(Solver solver, const Model& model, std::span<const double> start,
               const Options& options) {
  if (chosen(solver) == Solver::gauss_newton) return solve_gauss_newton(model, start, options);
  if (!can_solve(solver, model)) {
    Solution refused = DenseModel(model, start, options).finish(Stop::failed, 0, {});
    refused.stop = Stop::failed;  // even where the start is infeasible: nothing was tried
    return refused;
  }
  return is_global(solver) ? search_globally(solver, model, start, options)
                           : solve_dense(solver, model, start, options);
}

}  // namespace cognate::synthesis
