#include "problems/function/length_ranges.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cognate::problems {
namespace {

constexpr double kWidestRatio = 100;  ///< default limit of a free length, against the fixed ones

}  // namespace

std::array<Range, 4> length_ranges(const FunctionProblem& problem) {
  const Given& given = problem.given;
  const Bounds& bounds = problem.bounds;
  const std::array fixed{given.crank, given.coupler, given.rocker, given.frame};
  const std::array limits{bounds.crank, bounds.coupler, bounds.rocker, bounds.frame};
  double least = std::numeric_limits<double>::infinity(), greatest = 0;
  const auto extend = [&](double length) {
    if (!std::isfinite(length) || length <= 0) return;
    least = std::min(least, length);
    greatest = std::max(greatest, length);
  };
  for (int i = 0; i < 4; ++i) {
    if (fixed[i]) extend(*fixed[i]);
  }
  if (greatest == 0) least = greatest = 1;
  for (int i = 0; i < 4; ++i) {
    if (limits[i] && limits[i]->min > greatest) extend(limits[i]->min);
    if (limits[i] && limits[i]->max < least) extend(limits[i]->max);
  }
  const double ratio = std::max(kWidestRatio, problem.constraints.link_ratio_max.value_or(0));
  std::array<Range, 4> ranges;
  for (int i = 0; i < 4; ++i) {
    if (fixed[i]) {
      ranges[i] = {*fixed[i], *fixed[i]};
      continue;
    }
    ranges[i] = {least / ratio, greatest * ratio};
    if (!limits[i]) continue;
    if (std::isfinite(limits[i]->max)) ranges[i].max = limits[i]->max;
    // A bound of zero means more than 1e-6 of the largest link.
    const double positive = 2e-6 * std::max(ranges[i].max, greatest);
    if (std::isfinite(limits[i]->min)) ranges[i].min = std::max(limits[i]->min, positive);
    ranges[i].min = std::min(ranges[i].min, ranges[i].max);
  }
  return ranges;
}

}  // namespace cognate::problems
