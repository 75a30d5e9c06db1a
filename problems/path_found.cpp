#include "problems/path_found.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "synthesis/optimise/loss.hpp"

namespace cognate::problems {
namespace {

bool is_same(const PathMinimum& a, const PathMinimum& b, double tolerance) {
  if (a.assembly != b.assembly || a.clockwise != b.clockwise) return false;
  if (a.confined_to != b.confined_to) return false;
  for (std::size_t i = 0; i < a.solution.x.size(); ++i) {
    const double difference = std::abs(a.solution.x[i] - b.solution.x[i]);
    if (difference > tolerance * (1 + std::abs(a.solution.x[i]))) return false;
  }
  return true;
}

}  // namespace

bool is_better(const PathFound& found, const PathFound& other) {
  if (found.strays != other.strays) return other.strays;
  const synthesis::Solution &a = found.minimum.solution, &b = other.minimum.solution;
  const bool a_feasible = a.violation <= kPathFeasibility;
  const bool b_feasible = b.violation <= kPathFeasibility;
  if (a_feasible != b_feasible) return a_feasible;
  return a_feasible ? a.objective < b.objective : a.violation < b.violation;
}

bool costs_less(const PathFound& a, const PathFound& b) {
  if (a.strays != b.strays) return b.strays;
  return a.cost < b.cost;
}

void sort_and_merge(std::vector<PathFound>& all,
                    const std::function<bool(const PathFound&, const PathFound&)>& before,
                    double tolerance) {
  std::erase_if(all, [](const PathFound& found) { return !found.valid; });
  std::ranges::stable_sort(all, before);
  std::vector<PathFound> distinct;
  for (PathFound& found : all) {
    const auto known = std::ranges::find_if(distinct, [&](const PathFound& other) {
      return is_same(other.minimum, found.minimum, tolerance);
    });
    if (known == distinct.end()) {
      distinct.push_back(std::move(found));
    } else {
      known->hits += found.hits;
      known->minimum.from_exact = known->minimum.from_exact || found.minimum.from_exact;
    }
  }
  all = std::move(distinct);
}

synthesis::Solution minimise(const PathProblem& problem, PathFound& found,
                             synthesis::Backend backend, const synthesis::Options& options) {
  const PathModel model = model_of(problem, found.minimum);
  const Solve& asked = problem.solve;
  synthesis::Solution solution = solve_by_loss(backend, model, asked.loss, asked.loss_scale, 2,
                                               found.minimum.solution.x, options);
  found.evaluations += solution.evaluations;
  found.gradients += solution.gradients;
  found.iterations += static_cast<std::uint64_t>(solution.iterations);
  return solution;
}

void count_work(std::span<PathFound> all, std::size_t points, Work& work) {
  for (PathFound& found : all) {
    work.positions += std::exchange(found.evaluations, 0) * points;
    work.gradients += std::exchange(found.gradients, 0) * points;
    work.solver_iterations += std::exchange(found.iterations, 0);
  }
}

}  // namespace cognate::problems
