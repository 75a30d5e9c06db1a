#include "problems/path/pivot_model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/numbers/constants.hpp"

namespace cognate::problems {

/// The frame from A to D: its length and direction.
struct PivotPathModel::Frame {
  double length = 0;
  Vec2d along;
};

PivotPathModel::PivotPathModel(const PathProblem& problem, Assembly assembly, bool clockwise)
    : inner_(problem, assembly, clockwise),
      length_(problem.bounds.frame),
      angle_(problem.bounds.frame_angle),
      other_is_d_(!problem.given.pivot_d || problem.given.pivot_a),
      fixed_anchor_(other_is_d_ ? problem.given.pivot_a.value_or(Vec2d{})
                                : problem.given.pivot_d.value_or(Vec2d{})),
      anchor_x_(place_of(PathModel::anchor_x)),
      other_x_(place_of(PathModel::frame)),
      other_y_(place_of(PathModel::angle)),
      variables_(inner_.variables().begin(), inner_.variables().end()) {
  constexpr double kFarthest = 2000;  // sizes of the path, as for the anchor
  const auto& box = other_is_d_ ? problem.bounds.pivot_d : problem.bounds.pivot_a;
  const Box within = box.value_or(Box{{-kFarthest, -kFarthest}, {kFarthest, kFarthest}});
  variables_[static_cast<std::size_t>(other_x_)] = {
      "other pivot x", std::max(within.min.x, -kFarthest), std::min(within.max.x, kFarthest), 1};
  variables_[static_cast<std::size_t>(other_y_)] = {
      "other pivot y", std::max(within.min.y, -kFarthest), std::min(within.max.y, kFarthest), 1};
}

/// −1 where the file fixes it.
int PivotPathModel::place_of(int dimension) const {
  const auto free = inner_.free_dimensions();
  const auto found = std::ranges::find(free, dimension);
  return found == free.end() ? -1 : static_cast<int>(found - free.begin());
}

Vec2d PivotPathModel::anchor(std::span<const double> x) const {
  if (anchor_x_ < 0) return fixed_anchor_;
  const auto at = static_cast<std::size_t>(anchor_x_);
  return {x[at], x[at + 1]};
}

PivotPathModel::Frame PivotPathModel::frame(std::span<const double> x) const {
  const Vec2d other{x[static_cast<std::size_t>(other_x_)], x[static_cast<std::size_t>(other_y_)]};
  const Vec2d way = other_is_d_ ? other - anchor(x) : anchor(x) - other;
  const double length = norm(way);
  return {length, length > 0 ? (1 / length) * way : Vec2d{1, 0}};
}

std::vector<double> PivotPathModel::inwards(std::span<const double> x) const {
  std::vector<double> inner(x.begin(), x.end());
  const Frame at = frame(x);
  inner[static_cast<std::size_t>(other_x_)] = at.length;
  inner[static_cast<std::size_t>(other_y_)] = std::atan2(at.along.y, at.along.x);
  return inner;
}

std::vector<double> PivotPathModel::outwards(std::span<const double> x) const {
  std::vector<double> outer(x.begin(), x.end());
  const double length = x[static_cast<std::size_t>(other_x_)];
  const double angle = x[static_cast<std::size_t>(other_y_)];
  const Vec2d way = length * Vec2d{std::cos(angle), std::sin(angle)};
  const Vec2d other = other_is_d_ ? anchor(x) + way : anchor(x) - way;
  outer[static_cast<std::size_t>(other_x_)] = other.x;
  outer[static_cast<std::size_t>(other_y_)] = other.y;
  return outer;
}

/// Derivatives by length and angle of the frame become those by its pivots.
void PivotPathModel::exchange_columns(const Frame& frame, std::span<double> row) const {
  const double by_length = row[static_cast<std::size_t>(other_x_)];
  const double by_turn = row[static_cast<std::size_t>(other_y_)] / frame.length;
  const Vec2d by_way = by_length * frame.along + by_turn * perp(frame.along);
  const Vec2d by_other = (other_is_d_ ? 1.0 : -1.0) * by_way;
  row[static_cast<std::size_t>(other_x_)] = by_other.x;
  row[static_cast<std::size_t>(other_y_)] = by_other.y;
  if (anchor_x_ < 0) return;
  const auto at = static_cast<std::size_t>(anchor_x_);
  row[at] -= by_other.x;
  row[at + 1] -= by_other.y;
}

bool PivotPathModel::residuals(std::span<const double> x, std::span<double> r,
                               std::span<double> jacobian, std::span<double> local) const {
  const Frame at = frame(x);
  if (!(at.length > 0)) return false;
  if (!inner_.residuals(inwards(x), r, jacobian, local)) return false;
  const auto n = static_cast<std::size_t>(global_count());
  for (std::size_t row = 0; row * n < jacobian.size(); ++row) {
    exchange_columns(at, jacobian.subspan(row * n, n));
  }
  return true;
}

int PivotPathModel::limit_count() const {
  return (length_ ? 2 : 0) + (angle_ ? 1 : 0);
}

void PivotPathModel::constraints(std::span<const double> x, std::span<double> c,
                                 std::span<double> jacobian) const {
  const auto n = static_cast<std::size_t>(global_count());
  const auto rows = static_cast<std::size_t>(inner_.constraint_count());
  Frame at = frame(x);
  if (!(at.length > 0)) at.length = std::numeric_limits<double>::min();
  std::vector<double> inner = inwards(x);
  inner[static_cast<std::size_t>(other_x_)] = at.length;
  inner_.constraints(inner, c.first(rows), jacobian.empty() ? jacobian : jacobian.first(rows * n));
  if (!jacobian.empty()) std::ranges::fill(jacobian.subspan(rows * n), 0.0);
  limit_frame(at, c.subspan(rows), jacobian.empty() ? jacobian : jacobian.subspan(rows * n));
  for (std::size_t row = 0; row * n < jacobian.size(); ++row) {
    exchange_columns(at, jacobian.subspan(row * n, n));
  }
}

/// The bounds of the frame, with derivatives by its length and angle: of an angle, that it is no
/// farther from the middle than half the range.
void PivotPathModel::limit_frame(const Frame& frame, std::span<double> c,
                                 std::span<double> jacobian) const {
  const auto n = static_cast<std::size_t>(global_count());
  std::size_t row = 0;
  const auto set = [&](double value, int place, double slope) {
    c[row] = value;
    if (!jacobian.empty()) jacobian[row * n + static_cast<std::size_t>(place)] = slope;
    ++row;
  };
  if (length_) {
    set(frame.length - length_->min, other_x_, 1);
    // An open end is no limit, but its row has a value.
    set(std::isfinite(length_->max) ? length_->max - frame.length : 1, other_x_,
        std::isfinite(length_->max) ? -1 : 0);
  }
  if (!angle_) return;
  const double middle = 0.5 * (angle_->min + angle_->max);
  const double half = 0.5 * (angle_->max - angle_->min);
  const double away = std::remainder(std::atan2(frame.along.y, frame.along.x) - middle, kTurn);
  set(half - std::abs(away), other_y_, away > 0 ? -1 : 1);
}

}  // namespace cognate::problems
