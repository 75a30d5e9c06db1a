#include "problems/chain/chosen_targets.hpp"

#include <algorithm>

#include "analysis/numbers/constants.hpp"

namespace cognate::problems {

ChosenTargets::ChosenTargets(const ScaledChain& problem, std::size_t most) {
  const std::size_t points = problem.points.size();
  const std::size_t count = std::min(points, most);
  const std::size_t last = problem.closed ? points : points - 1;
  const std::size_t steps = problem.closed ? count : count - 1;
  for (std::size_t i = 0; i < count; ++i) which.push_back(i * last / steps);
}

std::vector<double> ChosenTargets::chosen(const ScaledChain& problem,
                                          const std::vector<double>& angles) const {
  if (problem.timed()) return angles;
  std::vector<double> own;
  for (const std::size_t one : which) own.push_back(angles[one]);
  return own;
}

std::vector<double> ChosenTargets::at_all(const ScaledChain& problem,
                                          const std::vector<double>& angles) const {
  if (problem.timed() || which.size() == problem.points.size()) return angles;
  std::vector<double> all;
  const double turn = angles.back() > angles.front() ? kTurn : -kTurn;
  for (std::size_t i = 0; i < which.size(); ++i) {
    const bool last = i + 1 == which.size();
    const std::size_t end = last ? problem.points.size() : which[i + 1];
    const double from = angles[i], to = last ? angles.front() + turn : angles[i + 1];
    for (std::size_t j = which[i]; j < end; ++j) {
      all.push_back(from + (to - from) * double(j - which[i]) / double(end - which[i]));
    }
  }
  return all;
}

}  // namespace cognate::problems
