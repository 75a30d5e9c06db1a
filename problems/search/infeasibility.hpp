/// @file Which constraints fight where no design satisfies all of them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "problems/linkage/linkage_limits.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// Whether a design is found under other limits, all else being the same.
using Feasibility = std::function<bool(const Constraints& constraints, const Bounds& bounds)>;

/// Sentences for the user: the constraints each of which stands alone in the way, with the least
/// change of its limits that makes a design possible, to about a hundredth of the way to no limit;
/// else the fewest that must give way together. Empty if there is no constraint, if nothing helps,
/// or where `is_over` before that is known.
///
/// It asks `feasible` some dozen times, first without any change, and is as sure as its answers.
/// Bounds of angles are not looked at.
std::vector<std::string> explain_infeasibility(const Constraints& constraints, const Bounds& bounds,
                                               const Feasibility& feasible,
                                               const std::function<bool()>& is_over);

/// What the work of a search under `constraints` costs, in positions of a linkage: about a tenth of
/// a microsecond each. An iteration under limits over the turn evaluates the whole turn.
double cost_in_positions(const Work& work, const Constraints& constraints);

/// The cost up to which an explanation is sought: that of half a minute or so, but the same on
/// every machine.
inline constexpr double kMostExplaining = 3e8;

/// Adds that to the notes of a result without a sound design. `solve_once` solves a changed
/// problem, which requests one design from few starts, and explains nothing.
template <class AnyProblem, class SolveOnce>
void add_infeasibility(const AnyProblem& problem, const Run& run, const Deadline& deadline,
                       const SolveOnce& solve_once, Result& result) {
  constexpr int kStarts = 250;
  if (result.status != Status::infeasible && result.status != Status::no_solution) return;
  run.enter(Phase::infeasibility, kUnknownEnd);
  double cost = 0;
  const Feasibility feasible = [&](const Constraints& constraints, const Bounds& bounds) {
    AnyProblem other = problem;
    other.constraints = constraints;
    other.bounds = bounds;
    other.solve = {.starts = kStarts, .designs = 1};
    const Result found = solve_once(other);
    cost += cost_in_positions(found.work, constraints);
    return found.status == Status::solved;
  };
  const auto is_over = [&] { return deadline.reached() || cost > kMostExplaining; };
  for (std::string& sentence :
       explain_infeasibility(problem.constraints, problem.bounds, feasible, is_over)) {
    result.notes.push_back(std::move(sentence));
  }
}

}  // namespace cognate::problems
