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
  const Vec2d unit{plane.normal.x / length, plane.normal.y / length};
  return {unit, (plane.bound - dot(plane.normal, centre)) / length};
}

/// Two half planes, the deeper first. Of the angle δ between their normals a and b,
/// cos δ = ±(1 − |b ∓ a|²/2) and sin δ = a × (b ∓ a) lose nothing where these are nearly or exactly
/// parallel or opposite.
struct Pair {
  double missing;  ///< what the foot on the first lacks of the second
  double sine;
  bool same_side;

  Pair(const Depth& a, const Depth& b) : same_side(dot(a.normal, b.normal) >= 0) {
    const double side = same_side ? 1 : -1;
    const Vec2d turn = b.normal - side * a.normal;
    missing = (b.depth - side * a.depth) + 0.5 * side * a.depth * squared_norm(turn);
    sine = cross(a.normal, turn);
  }
};

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
      const bool first = depths[i].depth >= depths[k].depth;
      const Depth &a = depths[first ? i : k], &b = depths[first ? k : i];
      if (a.depth <= 0) continue;
      const Pair pair(a, b);
      if (pair.missing <= 0) continue;  // the second adds nothing
      if (pair.sine == 0) {
        if (pair.same_side) continue;
        return std::nullopt;
      }
      const double aside = pair.missing / pair.sine;
      const double distance = std::hypot(a.depth, aside);
      if (distance > best.distance) {
        best = {centre + a.depth * a.normal + aside * perp(a.normal), distance, {i, k}};
      }
    }
  }
  return best;
}

}  // namespace cognate::synthesis
