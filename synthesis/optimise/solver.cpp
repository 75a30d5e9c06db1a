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

std::string_view name(Solver solver) {
  const auto index = static_cast<std::size_t>(solver);
  return index < kSolvers.size() ? kSolvers[index].name : std::string_view{};
}

bool is_global(Solver solver) {
  const auto index = static_cast<std::size_t>(solver);
  return index < kSolvers.size() && kSolvers[index].is_global;
}

bool linearises_residuals(Solver solver) {
  return chosen(solver) == Solver::gauss_newton || solver == Solver::ceres;
}

std::int64_t most_unknowns(Solver solver) {
  constexpr std::int64_t kMostOfAgs = 10;  // a limit of the library (ags::solverMaxDim)
  return solver == Solver::ags ? kMostOfAgs : std::numeric_limits<std::int64_t>::max();
}

bool eliminates_locals(Solver solver) {
  return chosen(solver) == Solver::gauss_newton;
}

bool can_solve(Solver solver, const Requirements& required) {
  if (required.unknowns > most_unknowns(solver)) return false;
  return solver != Solver::ceres ||
         (!required.constraints && required.objective == Objective::sum_of_squares);
}

bool can_solve(Solver solver, const Model& model) {
  const auto free = [](const Variable& variable) { return variable.lower < variable.upper; };
  return can_solve(solver, {.objective = model.objective(),
                            .constraints = model.constraint_count() > 0,
                            .unknowns = std::ranges::count_if(model.variables(), free)});
}

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
