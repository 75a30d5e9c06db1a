#include "analysis/numbers/hull_distance.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace cognate {
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

/// From the nearest point of the segment a to b to p.
Vec2d gap_to_point(const Vec2d& a, const Vec2d& b, const Vec2d& p) {
  const Vec2d way = b - a;
  const double square = squared_norm(way);
  const double share = square > 0 ? std::clamp(dot(p - a, way) / square, 0.0, 1.0) : 0;
  return p - a - share * way;
}

/// From the segment a to b to that from c to d.
Vec2d line_gap(const Vec2d& a, const Vec2d& b, const Vec2d& c, const Vec2d& d) {
  if (cross_each_other(a, b, c, d)) return {};
  return std::min({gap_to_point(a, b, c), gap_to_point(a, b, d), -gap_to_point(c, d, a),
                   -gap_to_point(c, d, b)},
                  [](const Vec2d& u, const Vec2d& v) { return norm(u) < norm(v); });
}

}  // namespace

Vec2d hull_gap(std::span<const Vec2d> a, std::span<const Vec2d> b) {
  if (holds(a, b.front()) || holds(b, a.front())) return {};
  Vec2d shortest{};
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < b.size(); ++k) {
      const Vec2d gap = line_gap(a[i], a[(i + 1) % a.size()], b[k], b[(k + 1) % b.size()]);
      if (const double length = norm(gap); length < least) {
        least = length;
        shortest = gap;
      }
    }
  }
  return shortest;
}

double hull_distance(std::span<const Vec2d> a, std::span<const Vec2d> b) {
  if (a.empty() || b.empty()) return std::numeric_limits<double>::infinity();
  return norm(hull_gap(a, b));
}

}  // namespace cognate
