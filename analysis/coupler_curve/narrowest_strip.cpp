#include "analysis/coupler_curve/narrowest_strip.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "analysis/numbers/compensated.hpp"

namespace cognate {
namespace {

bool comes_before(const Vec2d& a, const Vec2d& b) {
  return a.x < b.x || (a.x == b.x && a.y < b.y);
}

/// Twice the area of the triangle abc, its sign that of exact arithmetic but where twice the digits
/// do not tell: a hull that bends inwards by rounding would lose sides.
double turn(const Vec2d& a, const Vec2d& b, const Vec2d& c) {
  const Vec2d u = b - a, v = c - a;
  const double left = u.x * v.y, right = u.y * v.x;
  constexpr double kRounding = 4 * std::numeric_limits<double>::epsilon();
  if (std::abs(left - right) > kRounding * (std::abs(left) + std::abs(right))) return left - right;
  const auto difference = [](double to, double from) { return two_part_sum(to, -from); };
  return rounded_sum(product(difference(b.x, a.x), difference(c.y, a.y)),
                     -product(difference(b.y, a.y), difference(c.x, a.x)));
}

struct Heights {
  double low = 0, high = 0;
};

/// Of the points above the line through `origin`, which is among them.
Heights heights_across(std::span<const Vec2d> points, const Vec2d& origin, const Vec2d& direction) {
  Heights heights;
  for (const Vec2d& point : points) {
    const double height = cross(direction, point - origin);
    heights.low = std::min(heights.low, height);
    heights.high = std::max(heights.high, height);
  }
  return heights;
}

}  // namespace

double half_width_across(std::span<const Vec2d> points, const Vec2d& direction) {
  const auto [low, high] = heights_across(points, points[0], direction);
  return 0.5 * (high - low);
}

void StripFinder::find_hull(std::span<const Vec2d> points) {
  hull_.clear();
  const auto add = [this](std::size_t keep, const Vec2d& point) {
    while (hull_.size() > keep) {
      const Vec2d& last = hull_.back();
      const Vec2d& before = hull_[hull_.size() - 2];
      if (turn(before, last, point) > 0) break;
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
    // The walk may end early where rounding hides that heights still rise: what is taken for
    // narrower is measured.
    if (0.5 * height(far) >= best.half_width) continue;
    const auto [low, high] = heights_across(hull_, hull_[i], along);
    const double half = 0.5 * (high - low);
    if (half >= best.half_width) continue;
    best = {hull_[i] + 0.5 * (low + high) * perp(along), along, half};
  }
  if (best.half_width == std::numeric_limits<double>::infinity()) best.half_width = 0;
  if (best.direction.x < 0) best.direction = -best.direction;
  return best;
}

}  // namespace cognate
