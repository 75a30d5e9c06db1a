#include "problems/search/perturbations.hpp"

#include <algorithm>
#include <cmath>

#include "problems/tolerance/draws.hpp"

namespace cognate::problems {
namespace {

/// Moves the variable that a dimension is by a change of the dimension.
void move_along(const synthesis::AxisVariable& axis, double change, std::span<double> moved,
                std::span<double> slope) {
  const auto place = static_cast<std::size_t>(axis.variable);
  const double before = axis.to_value(moved[place]), after = before + change;
  moved[place] = axis.of_value(after);
  if (axis.is_logarithm) slope[place] = (before - axis.offset) / (after - axis.offset);
}

}  // namespace

DrawnPerturbation::DrawnPerturbation(const RobustStart& start, ToleranceDistribution distribution,
                                     std::uint64_t seed, std::size_t count)
    : start_(start), count_(count), changes_(start.dimensions.size() * count) {
  draw_changes(start.dimensions, distribution, seed, 0, count, changes_);
}

void DrawnPerturbation::move(std::span<const double> x, std::size_t sample, std::span<double> moved,
                             std::span<double> slope) const {
  std::ranges::copy(x, moved.begin());
  std::ranges::fill(slope, 1.0);
  for (std::size_t d = 0; d < start_.variables.size(); ++d) {
    move_along(start_.variables[d], changes_[d * count_ + sample], moved, slope);
  }
}

SpreadPerturbation::SpreadPerturbation(const RobustStart& start, ToleranceDistribution distribution,
                                       double share)
    : start_(start) {
  const double away = std::sqrt(static_cast<double>(start.dimensions.size())) /
                      deviations_in_half_width(distribution);
  for (const TolerancedDimension& dimension : start.dimensions) {
    middle_.push_back(share * dimension.middle());
    away_.push_back(share * away * dimension.half_width());
  }
}

void SpreadPerturbation::move(std::span<const double> x, std::size_t sample,
                              std::span<double> moved, std::span<double> slope) const {
  std::ranges::copy(x, moved.begin());
  std::ranges::fill(slope, 1.0);
  for (std::size_t d = 0; d < away_.size(); ++d) {
    const double away = d != sample / 2 ? 0 : sample % 2 == 0 ? away_[d] : -away_[d];
    move_along(start_.variables[d], middle_[d] + away, moved, slope);
  }
}

LevelPerturbation::LevelPerturbation(const RobustStart& start, std::size_t levels)
    : start_(start), levels_(levels) {
  for (std::size_t d = 0; d < start.dimensions.size(); ++d) count_ *= levels;
}

void LevelPerturbation::move(std::span<const double> x, std::size_t sample, std::span<double> moved,
                             std::span<double> slope) const {
  std::ranges::copy(x, moved.begin());
  std::ranges::fill(slope, 1.0);
  for (std::size_t d = 0; d < start_.variables.size(); ++d) {
    const TolerancedDimension& dimension = start_.dimensions[d];
    const double share = static_cast<double>(sample % levels_) / static_cast<double>(levels_ - 1);
    sample /= levels_;
    move_along(start_.variables[d], dimension.middle() + (2 * share - 1) * dimension.half_width(),
               moved, slope);
  }
}

}  // namespace cognate::problems
