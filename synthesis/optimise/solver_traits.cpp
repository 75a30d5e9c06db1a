/// What solvers are called and can do.
#include <algorithm>
#include <limits>

#include "synthesis/optimise/solver.hpp"

namespace cognate::synthesis {

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

}  // namespace cognate::synthesis
