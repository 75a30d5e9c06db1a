#include "analysis/numbers/convex_hull.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>

namespace cognate {
namespace {

bool turns_left(const Vec2d& a, const Vec2d& b, const Vec2d& c, double tolerance) {
  const Vec2d line = c - a;
  return cross(b - a, c - b) > tolerance * std::sqrt(squared_norm(line));
}

/// The corners from the first point to the last along the right of the line between them.
template <class Iterator>
std::vector<Vec2d> chain(Iterator first, const Iterator& last, double tolerance) {
  std::vector<Vec2d> corners;
  for (; first != last; ++first) {
    while (corners.size() > 1 &&
           !turns_left(corners.end()[-2], corners.back(), *first, tolerance)) {
      corners.pop_back();
    }
    corners.push_back(*first);
  }
  return corners;
}

}  // namespace

std::vector<Vec2d> convex_hull(std::vector<Vec2d> points, double tolerance) {
  const auto before = [](const Vec2d& a, const Vec2d& b) {
    return std::tie(a.x, a.y) < std::tie(b.x, b.y);
  };
  const auto near = [&](const Vec2d& a, const Vec2d& b) {
    return squared_norm(a - b) <= tolerance * tolerance;
  };
  std::sort(points.begin(), points.end(), before);
  points.erase(std::unique(points.begin(), points.end(), near), points.end());
  if (points.size() < 3) return points;
  std::vector<Vec2d> hull = chain(points.begin(), points.end(), tolerance);
  const std::vector<Vec2d> upper = chain(points.rbegin(), points.rend(), tolerance);
  hull.pop_back();
  hull.insert(hull.end(), upper.begin(), upper.end() - 1);
  return hull;
}

}  // namespace cognate
