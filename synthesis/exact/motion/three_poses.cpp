#include "synthesis/exact/motion/three_poses.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "synthesis/exact/motion/seen_from_body.hpp"

namespace cognate::synthesis {
namespace {

using ThreePoses = std::span<const Pose, 3>;

constexpr double kThreePoseRounding = 16 * std::numeric_limits<double>::epsilon();

bool finite(ThreePoses poses, const Vec2d& v) {
  double sum = v.x + v.y;
  for (const Pose& pose : poses) sum += pose.at.x + pose.at.y + pose.angle;
  return std::isfinite(sum);
}

DyadSolutions answer(GuidanceStatus status) {
  return {status, {}, 0};
}

DyadSolutions one(GuidanceStatus status, GuidingDyad dyad, double condition) {
  DyadSolutions result = answer(status);
  dyad.condition = condition;
  result.add(dyad);
  return result;
}

/// The triangle of a moving pivot's three positions: `side[k]` leads from position k to the next,
/// each computed from its own displacement, so that close positions keep their difference.
struct Triangle {
  std::array<Vec2d, 3> corner;
  std::array<Vec2d, 3> side;
  std::array<double, 3> length;
  double noise = 0;  ///< what rounding of the data may move a corner by
};

Triangle triangle_of(ThreePoses poses, const Vec2d& in_body) {
  Triangle result;
  double size = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Pose& from = poses[k];
    result.corner[k] = to_frame(from, in_body);
    result.side[k] = displacement(from, poses[(k + 1) % 3]).way(result.corner[k]);
    result.length[k] = norm(result.side[k]);
    size = std::max(size, norm(from.at));
  }
  result.noise = kThreePoseRounding * (size + norm(in_body));
  return result;
}

std::size_t longest(const Triangle& t) {
  return static_cast<std::size_t>(std::max_element(t.length.begin(), t.length.end()) -
                                  t.length.begin());
}

/// From the corner across the longest side, with its sides a and b, the centre z satisfies z·a =
/// |a|²/2 and z·b = |b|²/2.
Vec2d centre_of(const Triangle& t, std::size_t long_side) {
  const std::size_t apex = (long_side + 2) % 3;
  const Vec2d a = t.side[apex], b = -t.side[(apex + 2) % 3];
  const double area = cross(a, b);
  return t.corner[apex] + (0.5 / area) * (squared_norm(b) * perp(a) - squared_norm(a) * perp(b));
}

/// Two positions are one: the fixed pivots are a bisector, of which the middle between the
/// positions is given, or none where the third is the same too.
DyadSolutions at_rest(ThreePoses poses, const Vec2d& in_body, const Triangle& t,
                      std::size_t long_side) {
  if (t.length[long_side] <= t.noise) return answer(GuidanceStatus::pivot_at_rest);
  const Vec2d middle = t.corner[long_side] + 0.5 * t.side[long_side];
  return one(GuidanceStatus::pivot_at_rest, rr_dyad(poses, in_body, middle), 1);
}

bool any_two_coincide(ThreePoses poses) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Displacement to = displacement(poses[k], poses[(k + 1) % 3]);
    const double noise = kThreePoseRounding * (norm(poses[k].at) + norm(to.shift));
    if (std::abs(to.angle) <= kThreePoseRounding && norm(to.shift) <= noise) return true;
  }
  return false;
}

}  // namespace

DyadSolutions dyads_with_moving_pivot(ThreePoses poses, const Vec2d& in_body) {
  if (!finite(poses, in_body)) return answer(GuidanceStatus::not_finite);
  const Triangle t = triangle_of(poses, in_body);
  const std::size_t side = longest(t);
  const double shortest = *std::min_element(t.length.begin(), t.length.end());
  if (shortest <= t.noise) {
    DyadSolutions result = at_rest(poses, in_body, t, side);
    if (any_two_coincide(poses)) result.status = GuidanceStatus::coincident_poses;
    return result;
  }
  const std::size_t apex = (side + 2) % 3;
  const double area = std::abs(cross(t.side[apex], t.side[(apex + 2) % 3]));
  const double height = area / t.length[side];
  // Errors of the corners, relative to the shortest side, turn the bisectors against one another.
  const double condition = t.length[side] / height;
  if (height <= t.noise) {
    const Vec2d direction = (1 / t.length[side]) * t.side[side];
    return one(GuidanceStatus::found, pr_dyad(poses, in_body, direction),
               t.length[side] / shortest);
  }
  return one(GuidanceStatus::found, rr_dyad(poses, in_body, centre_of(t, side)), condition);
}

DyadSolutions dyads_with_fixed_pivot(ThreePoses poses, const Vec2d& fixed) {
  const auto seen = seen_from_body(poses, fixed);
  return seen_from_frame(dyads_with_moving_pivot(seen, {}), poses, fixed);
}

/// The condition is linear in the moving pivot w, counted from the origin's first position: with n
/// across the line, n·((e_j − 1) w + s_j) = 0 for both displacements.
DyadSolutions dyads_with_slide_direction(ThreePoses poses, const Vec2d& direction) {
  if (!finite(poses, direction)) return answer(GuidanceStatus::not_finite);
  const double length = norm(direction);
  if (!(length > 0)) return answer(GuidanceStatus::none);
  const Vec2d along = (1 / length) * direction, across = perp(along);
  const Displacement a = displacement(poses[0], poses[1]), b = displacement(poses[0], poses[2]);
  // Re(conj(n) c w) = dot(conj(c) n, w).
  const Vec2d row_a = conj(a.turn_less_one) * across, row_b = conj(b.turn_less_one) * across;
  const double determinant = cross(row_a, row_b);
  const double right_a = -dot(across, a.shift), right_b = -dot(across, b.shift);
  const double sizes = norm(row_a) * norm(row_b);
  if (!(std::abs(determinant) > kThreePoseRounding * sizes)) {
    if (any_two_coincide(poses)) return answer(GuidanceStatus::coincident_poses);
    const bool turned = norm(row_a) > kThreePoseRounding || norm(row_b) > kThreePoseRounding;
    return answer(turned ? GuidanceStatus::none : GuidanceStatus::translation);
  }
  const Vec2d from_origin = (1 / determinant) * Vec2d{right_a * row_b.y - right_b * row_a.y,
                                                      right_b * row_a.x - right_a * row_b.x};
  const Vec2d in_body = to_body({{0, 0}, poses[0].angle}, from_origin);
  return one(GuidanceStatus::found, pr_dyad(poses, in_body, along), sizes / std::abs(determinant));
}

DyadSolutions dyads_with_line_direction(ThreePoses poses, const Vec2d& direction) {
  const auto seen = seen_from_body(poses, poses[0].at);
  return seen_from_frame(dyads_with_slide_direction(seen, direction), poses, poses[0].at);
}

PoleTriangle pole_triangle(ThreePoses poses) {
  return {pole(displacement(poses[0], poses[1])), pole(displacement(poses[1], poses[2])),
          pole(displacement(poses[2], poses[0]))};
}

}  // namespace cognate::synthesis
