/// @file Problems with more than the error to be best: Pareto fronts, and the best of a measure
/// within a bound on the error.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "problems/linkage/error_limit.hpp"
#include "problems/linkage/result.hpp"
#include "problems/search/objective_rules.hpp"

namespace cognate::problems {

/// How many local minima are requested under each bound: those that are not the best are starts
/// under others.
inline constexpr int kMinima = 6;

/// The objectives other than the error; empty if there are none.
std::optional<DesignObjective> measure_of(const Solve& solve);

/// The objectives of the file, the name of its error and how it is solved.
struct ObjectiveTask {
  DesignLimits limits;  ///< those of the file
  DesignObjective measure;
  bool with_error = true;  ///< a front; else the best measure alone
  int designs = 12;        ///< points of a front
  ErrorMeasure error;
  std::optional<ErrorLimit> limit;
  double met = 0;  ///< errors up to this are rounding
  std::function<double(const Design&)> error_of;
  /// Designs of least error within limits, from designs that are known and, unless `seed` is empty,
  /// from starts of its own. The same for the same arguments.
  std::function<Result(const DesignLimits& limits, const std::vector<Design>& known,
                       std::optional<std::uint64_t> seed)>
      solve;
};

/// A front, best error first, its levels as a family "Pareto front"; or the one best design.
Result solve_front(const ObjectiveTask& task, const Run& run, const Deadline& deadline);

/// Solves a problem for its `solve.objectives`. `solve_once(problem, run)` solves one whose only
/// objective is the error; `deadline` is that of the whole.
template <class AnyProblem, class SolveOnce>
Result solve_objectives(const AnyProblem& problem, const Run& run, const Deadline& deadline,
                        const SolveOnce& solve_once) {
  const auto measure = measure_of(problem.solve);
  if (!measure) return solve_once(problem, run);
  const auto solve = [&](const DesignLimits& limits, const std::vector<Design>& known,
                         std::optional<std::uint64_t> seed) {
    AnyProblem other = problem;
    other.constraints = limits.constraints;
    other.constraints.error.reset();
    other.bounds = limits.bounds;
    other.solve.objectives.clear();
    other.solve.designs = kMinima;
    if (!seed) other.solve.starts = 0;
    Run own = silent(run);
    own.known = known;
    own.seed = seed.value_or(run.seed);
    return solve_once(other, own);
  };
  const ObjectiveTask task{
      .limits = {problem.constraints, problem.bounds},
      .measure = *measure,
      .with_error = problem.solve.objectives.size() > 1,
      .designs = problem.solve.designs,
      .error = error_measure(problem),
      .limit = problem.constraints.error,
      .met = met_error(problem),
      .error_of = [&](const Design& design) { return error_of(problem, design); },
      .solve = solve};
  return solve_front(task, run, deadline);
}

}  // namespace cognate::problems
