#include "synthesis/exact/cam/half_planes.hpp"

#include <cmath>
#include <limits>

namespace cognate::synthesis {
namespace {

/// Half plane as unit normal and signed distance of `centre` from being inside (> 0: outside).
struct Depth {
  Vec2d normal;
  double depth;
};

Depth depth_of(const Vec2d& centre, const HalfPlane& plane) {
  const double length = norm(plane.normal);
  const Vec2d unit = (1 / length) * plane.normal;
  return {unit, (plane.bound - dot(plane.normal, centre)) / length};
}

/// Where both bounds hold with equality, from the centre.
struct Corner {
  Vec2d from_centre;
  bool exists;
};

Corner corner(const Depth& a, const Depth& b) {
  const double determinant = cross(a.normal, b.normal);
  if (determinant == 0) return {{}, false};
  return {{(a.depth * b.normal.y - b.depth * a.normal.y) / determinant,
           (b.depth * a.normal.x - a.depth * b.normal.x) / determinant},
          true};
}

/// Whether the foot on `a` alone satisfies `b` too: then `b` adds nothing.
bool foot_satisfies(const Depth& a, const Depth& b) {
  return a.depth * dot(a.normal, b.normal) >= b.depth;
}

}  // namespace

std::optional<NearestPoint> nearest_point(const Vec2d& centre, std::span<const HalfPlane> planes) {
  std::vector<Depth> depths;
  depths.reserve(planes.size());
  for (const HalfPlane& plane : planes) depths.push_back(depth_of(centre, plane));

  NearestPoint best{centre, 0, {}};
  for (std::size_t i = 0; i < depths.size(); ++i) {
    const Depth& a = depths[i];
    if (a.depth > best.distance) best = {centre + a.depth * a.normal, a.depth, {i}};
  }
  for (std::size_t i = 0; i < depths.size(); ++i) {
    for (std::size_t k = i + 1; k < depths.size(); ++k) {
      const Depth &a = depths[i], &b = depths[k];
      if (a.depth <= 0 && b.depth <= 0) continue;
      if ((a.depth > 0 && foot_satisfies(a, b)) || (b.depth > 0 && foot_satisfies(b, a))) continue;
      const Corner both = corner(a, b);
      if (!both.exists) return std::nullopt;
      const double distance = norm(both.from_centre);
      if (distance > best.distance) best = {centre + both.from_centre, distance, {i, k}};
    }
  }
  return best;
}

}  // namespace cognate::synthesis
