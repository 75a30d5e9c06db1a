/// @file Which constraints fight where no design satisfies all of them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "problems/linkage/deadline.hpp"
#include "problems/linkage/linkage_limits.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// Whether a design is found under other limits, all else being the same.
using Feasibility = std::function<bool(const Constraints& constraints, const Bounds& bounds)>;

/// Sentences for the user: the constraints each of which stands alone in the way, with the least
/// change of its limits that makes a design possible, to about a hundredth of the way to no limit;
/// else the fewest that must give way together. Empty if there is no constraint, if nothing helps,
/// or when half a minute or the deadline is over before that is known.
///
/// It asks `feasible` some dozen times, first without any change, and is as sure as its answers.
/// Bounds of angles are not looked at.
std::vector<std::string> explain_conflict(const Constraints& constraints, const Bounds& bounds,
                                          const Feasibility& feasible, const Deadline& deadline);

/// Adds that to the notes of a result without a sound design. `solve_once` solves a changed
/// problem, which asks for one design from few starts, and explains nothing.
template <class AnyProblem, class SolveOnce>
void tell_conflict(const AnyProblem& problem, const Deadline& deadline, const SolveOnce& solve_once,
                   Result& result) {
  constexpr int kStarts = 250;
  if (result.status != Status::infeasible && result.status != Status::no_solution) return;
  const Feasibility feasible = [&](const Constraints& constraints, const Bounds& bounds) {
    AnyProblem other = problem;
    other.constraints = constraints;
    other.bounds = bounds;
    other.solve = {.starts = kStarts, .designs = 1};
    return solve_once(other).status == Status::solved;
  };
  for (std::string& sentence :
       explain_conflict(problem.constraints, problem.bounds, feasible, deadline)) {
    result.notes.push_back(std::move(sentence));
  }
}

}  // namespace cognate::problems
