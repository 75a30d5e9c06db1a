#include "problems/guidance/relaxations.hpp"

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>

namespace cognate::problems {

std::vector<MotionProblem> relaxations(const MotionProblem& problem) {
  const auto drop_class = [](MotionProblem& p) {
    return std::exchange(p.constraints.required_class, std::nullopt).has_value();
  };
  const auto drop_transmission = [](MotionProblem& p) {
    return std::exchange(p.constraints.transmission_angle, std::nullopt).has_value();
  };
  const auto drop_places = [](MotionProblem& p) {
    const auto& [pivot_a, pivot_d] = std::tie(p.bounds.pivot_a, p.bounds.pivot_d);
    const bool any = pivot_a || pivot_d || p.constraints.pivot_region || p.moving_bounds[0] ||
                     p.moving_bounds[1];
    p.bounds.pivot_a = p.bounds.pivot_d = p.constraints.pivot_region = std::nullopt;
    p.moving_bounds = {};
    return any;
  };
  const auto drop_lengths = [](MotionProblem& p) {
    Bounds& bounds = p.bounds;
    const bool any = bounds.crank || bounds.coupler || bounds.rocker || bounds.frame ||
                     p.constraints.link_ratio_max;
    bounds.crank = bounds.coupler = bounds.rocker = bounds.frame = std::nullopt;
    p.constraints.link_ratio_max = std::nullopt;
    return any;
  };
  std::vector<MotionProblem> relaxed;
  MotionProblem free = problem;
  const auto relax = [&](const auto& drop) {
    MotionProblem without = problem;
    if (drop(without)) relaxed.push_back(std::move(without));
    drop(free);
  };
  relax(drop_class);
  relax(drop_transmission);
  relax(drop_places);
  relax(drop_lengths);
  if (relaxed.size() > 1) relaxed.push_back(std::move(free));
  const auto& [required, transmission] =
      std::tie(problem.constraints.required_class, problem.constraints.transmission_angle);
  if (transmission && !required) relaxed.push_back(problem);
  return relaxed;
}

std::vector<std::size_t> in_even_steps(std::size_t count) {
  constexpr std::size_t kMostPoses = 40;
  const std::size_t kept = std::min(count, kMostPoses);
  std::vector<std::size_t> numbers(kept);
  for (std::size_t k = 0; k < kept; ++k) {
    numbers[k] = kept == count ? k : k * (count - 1) / (kept - 1);
  }
  return numbers;
}

MotionProblem only(const MotionProblem& problem, const std::vector<std::size_t>& numbers) {
  MotionProblem some = problem;
  some.poses.clear();
  for (const std::size_t number : numbers) some.poses.push_back(problem.poses[number]);
  return some;
}

}  // namespace cognate::problems
