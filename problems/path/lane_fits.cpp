#include "problems/path/lane_fits.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "analysis/linkage/mobility.hpp"

namespace cognate::problems {
namespace {

using synthesis::Solution;

double largest_violation(const PathModel& model, std::span<const double> x) {
  std::vector<double> limits(model.constraint_count());
  model.constraints(x, limits, {});
  double most = 0;
  for (const double c : limits) most = std::max(most, -c);
  return most;
}

/// Where the transmission angle is limited over the way of the crank, one that has started to turn
/// fully has to keep it over the turn: it is then kept to its class, and to those limits.
void confine_turning(const PathProblem& problem, const PathModel& model, double penalty,
                     PathFound& found) {
  const auto& x = found.minimum.solution.x;
  const Lengths<double> links = lengths(model.linkage(x));
  if (!model.transmission_on_the_way() || !crank_rotates(links)) return;
  const auto own = open_class(problem.constraints, links);
  if (!own) return;
  found.minimum.confined_to = own;
  double& violation = found.minimum.solution.violation;
  violation = largest_violation(model_of(problem, found.minimum), x);
  found.cost = found.minimum.solution.objective + penalty * violation * (penalty * violation);
}

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
  std::vector<double> residuals(model.residual_count());
  found.valid = std::isfinite(state.cost) && model.residuals(solution.x, residuals, {}, {});
  if (!found.valid) return;
  solution.objective = 0;
  for (const double r : residuals) solution.objective += r * r;
  solution.violation = largest_violation(model, solution.x);
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
      const PathModel model = model_of(problem, left[i]->minimum);
      take_over(model, states[i], *left[i]);
      if (left[i]->fitted && left[i]->valid) {
        confine_turning(problem, model, options.penalty, *left[i]);
      }
    }
    left.erase(left.begin(), others);
  }
}

}  // namespace cognate::problems
