#include "analysis/coupler_curve/narrowest_strip.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace cognate {
namespace {

bool comes_before(const Vec2d& a, const Vec2d& b) {
  return a.x < b.x || (a.x == b.x && a.y < b.y);
}

}  // namespace

double half_width_across(std::span<const Vec2d> points, const Vec2d& direction) {
  double low = 0, high = 0;
  for (const Vec2d& point : points) {
    const double height = cross(direction, point - points[0]);
    low = std::min(low, height);
    high = std::max(high, height);
  }
  return 0.5 * (high - low);
}

void StripFinder::find_hull(std::span<const Vec2d> points) {
  hull_.clear();
  const auto add = [this](std::size_t keep, const Vec2d& point) {
    while (hull_.size() > keep) {
      const Vec2d& last = hull_.back();
      const Vec2d& before = hull_[hull_.size() - 2];
      if (cross(last - before, point - before) > 0) break;
      hull_.pop_back();
    }
    hull_.push_back(point);
  };
  for (const Vec2d& point : points) add(1, point);
  const std::size_t lower = hull_.size();
  for (std::size_t i = points.size() - 1; i-- > 0;) add(lower, points[i]);
  if (hull_.size() > 1) hull_.pop_back();
}

NarrowestStrip StripFinder::operator()(std::span<Vec2d> points) {
  if (points.empty()) return {};
  if (!std::ranges::is_sorted(points, comes_before)) std::ranges::sort(points, comes_before);
  find_hull(points);
  const std::size_t count = hull_.size();
  if (count == 1) return {hull_[0], {1, 0}, 0};
  NarrowestStrip best{hull_[0], {1, 0}, std::numeric_limits<double>::infinity()};
  std::size_t far = 1;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2d side = hull_[(i + 1) % count] - hull_[i];
    const double length = norm(side);
    if (length == 0) continue;
    const Vec2d along = (1 / length) * side;
    const auto height = [&](std::size_t k) { return cross(along, hull_[k % count] - hull_[i]); };
    if (far <= i) far = i + 1;
    while (far < i + count && height(far + 1) > height(far)) ++far;
    const double half = 0.5 * height(far);
    if (half < best.half_width) best = {hull_[i] + half * perp(along), along, half};
  }
  if (best.half_width == std::numeric_limits<double>::infinity()) best.half_width = 0;
  if (best.direction.x < 0) best.direction = -best.direction;
  return best;
}

}  // namespace cognate
