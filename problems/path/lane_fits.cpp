#include "problems/path/lane_fits.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace cognate::problems {
namespace {

using synthesis::Solution;

/// The point where a fit in lanes has ended, as `model` sees it.
void take_over(const PathModel& model, const synthesis::PathFitState& state, PathFound& found) {
  if (state.iterations == 0) {  // the time was up before its turn
    found.valid = found.fitted;
    return;
  }
  found.fitted = true;
  Solution& solution = found.minimum.solution;
  solution.x = model.variables_of(state, solution.x);
  found.cost = state.cost;
  found.evaluations += 2 * static_cast<std::uint64_t>(state.iterations);
  found.gradients += static_cast<std::uint64_t>(state.iterations);
  found.iterations += static_cast<std::uint64_t>(state.iterations);
  std::vector<double> residuals(model.residual_count()), limits(model.constraint_count());
  found.valid = std::isfinite(state.cost) && model.residuals(solution.x, residuals, {}, {});
  if (!found.valid) return;
  solution.objective = 0;
  for (const double r : residuals) solution.objective += r * r;
  model.constraints(solution.x, limits, {});
  solution.violation = 0;
  for (const double c : limits) solution.violation = std::max(solution.violation, -c);
}

}  // namespace

PathFound placed(const PathProblem& problem, const PathStart& start) {
  PathFound found;
  const auto confined_to = confining_class(problem.constraints, lengths(start.linkage));
  found.minimum = {start.linkage.assembly, start.clockwise, confined_to, {}};
  found.minimum.solution.x =
      model_of(problem, found.minimum).variables_of(start.linkage, start.crank_angles);
  found.valid = true;
  return found;
}

void fit_in_lanes(const PathProblem& problem, std::span<PathFound> all,
                  const synthesis::PathFitOptions& options) {
  std::vector<PathFound*> left;
  for (PathFound& found : all) {
    if (found.valid) left.push_back(&found);
  }
  while (!left.empty()) {
    const auto confined_to = left.front()->minimum.confined_to;
    const auto others = std::stable_partition(
        left.begin(), left.end(),
        [&](const PathFound* found) { return found->minimum.confined_to == confined_to; });
    std::vector<synthesis::PathFitState> states;
    for (auto it = left.begin(); it != others; ++it) {
      const PathMinimum& minimum = (*it)->minimum;
      states.push_back(model_of(problem, minimum).lane_state(minimum.solution.x));
    }
    fit_paths(model_of(problem, left.front()->minimum).lane_fit(), states, options);
    for (std::size_t i = 0; i < states.size(); ++i) {
      take_over(model_of(problem, left[i]->minimum), states[i], *left[i]);
    }
    left.erase(left.begin(), others);
  }
}

}  // namespace cognate::problems
