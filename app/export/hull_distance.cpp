#include "app/export/hull_distance.hpp"

#include <algorithm>
#include <limits>

#include "analysis/numbers/segment.hpp"

namespace cognate::app {
namespace {

bool holds(std::span<const Vec2d> hull, const Vec2d& p) {
  if (hull.size() < 3) return false;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vec2d& next = hull[(i + 1) % hull.size()];
    if (cross(next - hull[i], p - hull[i]) < 0) return false;
  }
  return true;
}

bool cross_each_other(const Vec2d& a, const Vec2d& b, const Vec2d& c, const Vec2d& d) {
  const double c_side = cross(b - a, c - a), d_side = cross(b - a, d - a);
  const double a_side = cross(d - c, a - c), b_side = cross(d - c, b - c);
  return (c_side > 0) != (d_side > 0) && (a_side > 0) != (b_side > 0);
}

double line_distance(const Vec2d& a, const Vec2d& b, const Vec2d& c, const Vec2d& d) {
  if (cross_each_other(a, b, c, d)) return 0;
  return std::min({distance_to_segment(a, c, d), distance_to_segment(b, c, d),
                   distance_to_segment(c, a, b), distance_to_segment(d, a, b)});
}

}  // namespace

double hull_distance(std::span<const Vec2d> a, std::span<const Vec2d> b) {
  if (a.empty() || b.empty()) return std::numeric_limits<double>::infinity();
  if (holds(a, b.front()) || holds(b, a.front())) return 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < b.size(); ++k) {
      least =
          std::min(least, line_distance(a[i], a[(i + 1) % a.size()], b[k], b[(k + 1) % b.size()]));
    }
  }
  return least;
}

}  // namespace cognate::app
