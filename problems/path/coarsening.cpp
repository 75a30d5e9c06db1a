#include "problems/path/coarsening.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include "analysis/numbers/constants.hpp"

namespace cognate::problems {
namespace {

template <class T>
std::vector<T> pick(const std::vector<T>& all, const std::vector<std::size_t>& kept) {
  if (all.empty()) return {};
  std::vector<T> picked;
  for (const std::size_t i : kept) picked.push_back(all[i]);
  return picked;
}

/// At most `most` of them, the first and last among these.
std::vector<std::size_t> in_even_steps(const std::vector<std::size_t>& all, std::size_t most) {
  if (all.size() <= most) return all;
  std::vector<std::size_t> kept;
  for (std::size_t k = 0; k < most; ++k) {
    kept.push_back(all[k * (all.size() - 1) / (most - 1)]);
  }
  return kept;
}

}  // namespace

PathCoarsening::PathCoarsening(const PathProblem& problem, std::size_t most)
    : whole_size_(problem.points.size()), coarse_(problem) {
  const bool thin = whole_size_ > most;
  std::vector<std::size_t> all(whole_size_), timed;
  std::iota(all.begin(), all.end(), std::size_t{0});
  kept_ = thin ? in_even_steps(all, most) : all;
  if (thin && problem.timing == Timing::mixed) {
    // A point that is timed says more than its neighbours.
    std::ranges::copy_if(all, std::back_inserter(timed),
                         [&](std::size_t j) { return problem.is_timed(j); });
    std::ranges::copy(in_even_steps(timed, most), std::back_inserter(kept_));
    std::ranges::sort(kept_);
    kept_.erase(std::unique(kept_.begin(), kept_.end()), kept_.end());
  }
  coarse_.points = pick(problem.points, kept_);
  coarse_.crank_angles = pick(problem.crank_angles, kept_);
  coarse_.has_crank_angle = pick(problem.has_crank_angle, kept_);
  coarse_.weights = pick(problem.weights, kept_);
}

std::vector<double> PathCoarsening::kept(const std::vector<double>& crank_angles) const {
  return pick(crank_angles, kept_);
}

std::vector<double> PathCoarsening::interpolated(std::span<const double> crank_angles) const {
  std::vector<double> all(whole_size_);
  all[kept_.front()] = crank_angles.front();
  for (std::size_t k = 0; k + 1 < kept_.size(); ++k) {
    // By the shorter way: neighbours are much less than half a turn apart.
    const double step = std::remainder(crank_angles[k + 1] - crank_angles[k], kTurn);
    const double gap = double(kept_[k + 1] - kept_[k]);
    for (std::size_t i = kept_[k]; i <= kept_[k + 1]; ++i) {
      all[i] = crank_angles[k] + step * double(i - kept_[k]) / gap;
    }
  }
  return all;
}

}  // namespace cognate::problems
