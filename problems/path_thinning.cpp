#include "problems/path_thinning.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cognate::problems {
namespace {

constexpr std::size_t kMostPoints = 48;

template <class T>
std::vector<T> pick(const std::vector<T>& all, const std::vector<std::size_t>& kept) {
  if (all.empty()) return {};
  std::vector<T> picked;
  for (const std::size_t i : kept) picked.push_back(all[i]);
  return picked;
}

}  // namespace

PathThinning::PathThinning(const PathProblem& problem)
    : whole_size_(problem.points.size()), coarse_(problem) {
  const bool thin = whole_size_ > kMostPoints && problem.order != PointOrder::any;
  const std::size_t count = thin ? kMostPoints : whole_size_;
  for (std::size_t k = 0; k < count; ++k) {
    kept_.push_back(thin ? k * (whole_size_ - 1) / (count - 1) : k);
  }
  coarse_.points = pick(problem.points, kept_);
  coarse_.crank_angles = pick(problem.crank_angles, kept_);
  coarse_.weights = pick(problem.weights, kept_);
}

std::vector<double> PathThinning::kept(const std::vector<double>& crank_angles) const {
  return pick(crank_angles, kept_);
}

std::vector<double> PathThinning::interpolated(std::span<const double> crank_angles) const {
  std::vector<double> all(whole_size_);
  all[kept_.front()] = crank_angles.front();
  for (std::size_t k = 0; k + 1 < kept_.size(); ++k) {
    // By the shorter way: neighbours are much less than half a turn apart.
    const double step = std::remainder(crank_angles[k + 1] - crank_angles[k], 2 * std::numbers::pi);
    const double gap = double(kept_[k + 1] - kept_[k]);
    for (std::size_t i = kept_[k]; i <= kept_[k + 1]; ++i) {
      all[i] = crank_angles[k] + step * double(i - kept_[k]) / gap;
    }
  }
  return all;
}

}  // namespace cognate::problems
