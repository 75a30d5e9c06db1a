#include "synthesis/exact/motion/two_poses.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "synthesis/exact/motion/seen_from_body.hpp"

namespace cognate::synthesis {
namespace {

constexpr double kTwoPoseRounding = 16 * std::numeric_limits<double>::epsilon();

bool finite(const Vec2d& v) {
  return std::isfinite(v.x) && std::isfinite(v.y);
}

bool finite(std::span<const Pose, 2> poses) {
  return finite(poses[0].at) && finite(poses[1].at) &&
         std::isfinite(poses[0].angle + poses[1].angle);
}

/// The two positions of a moving pivot.
struct Way {
  Vec2d from;
  Vec2d way;
  bool at_rest = false;  ///< within the rounding of the data
};

Way way_of(std::span<const Pose, 2> poses, const Vec2d& in_body) {
  const Displacement to = displacement(poses[0], poses[1]);
  Way result{to_frame(poses[0], in_body), {}, false};
  result.way = to.way(result.from);
  const double sizes = norm(poses[0].at) + norm(poses[1].at) + norm(in_body);
  result.at_rest = norm(result.way) <= kTwoPoseRounding * sizes;
  return result;
}

DyadSolutions one(const GuidingDyad& dyad) {
  DyadSolutions result{GuidanceStatus::found, {}, 0};
  result.add(dyad);
  return result;
}

DyadSolutions slider(std::span<const Pose, 2> poses, const Vec2d& in_body, const Way& way) {
  return one(pr_dyad(poses, in_body, (1 / norm(way.way)) * way.way));
}

}  // namespace

std::optional<Line> fixed_pivots_of(std::span<const Pose, 2> poses, const Vec2d& in_body) {
  const Way way = way_of(poses, in_body);
  if (!finite(way.from + way.way) || way.at_rest) return std::nullopt;
  return Line{way.from + 0.5 * way.way, (1 / norm(way.way)) * perp(way.way)};
}

std::optional<Line> moving_pivots_of(std::span<const Pose, 2> poses, const Vec2d& fixed) {
  const auto seen = seen_from_body(poses, fixed);
  return fixed_pivots_of(seen, {});
}

DyadSolutions dyads_with_fixed_pivot_on(std::span<const Pose, 2> poses, const Vec2d& in_body,
                                        const Line& line) {
  if (!finite(poses) || !finite(in_body) || !finite(line.point) || !finite(line.direction)) {
    return {GuidanceStatus::not_finite, {}, 0};
  }
  const Way way = way_of(poses, in_body);
  if (way.at_rest) return {GuidanceStatus::pivot_at_rest, {}, 0};
  const Vec2d along = (1 / norm(line.direction)) * line.direction;
  const Vec2d across = (1 / norm(way.way)) * way.way;
  const double slope = dot(across, along);
  const double gap = dot(across, way.from + 0.5 * way.way - line.point);
  if (std::abs(slope) <= kTwoPoseRounding) {
    const double sizes = norm(way.from) + norm(way.way) + norm(line.point);
    if (std::abs(gap) <= kTwoPoseRounding * sizes) return {GuidanceStatus::same_line, {}, 0};
    return slider(poses, in_body, way);
  }
  return one(rr_dyad(poses, in_body, line.point + (gap / slope) * along));
}

DyadSolutions dyads_with_moving_pivot_on(std::span<const Pose, 2> poses, const Vec2d& fixed,
                                         const Line& line) {
  const auto seen = seen_from_body(poses, fixed);
  return seen_from_frame(dyads_with_fixed_pivot_on(seen, {}, line), poses, fixed);
}

DyadSolutions dyads_of_length(std::span<const Pose, 2> poses, const Vec2d& in_body, double length) {
  if (!finite(poses) || !finite(in_body) || !std::isfinite(length)) {
    return {GuidanceStatus::not_finite, {}, 0};
  }
  const Way way = way_of(poses, in_body);
  if (way.at_rest) return {GuidanceStatus::pivot_at_rest, {}, 0};
  const double half = 0.5 * norm(way.way);
  const double square = (length - half) * (length + half);
  const double slack = kTwoPoseRounding * half * half;
  if (!(length > 0) || square < -slack) return {GuidanceStatus::out_of_reach, {}, 0};
  const Vec2d middle = way.from + 0.5 * way.way;
  const Vec2d across = (std::sqrt(std::max(square, 0.0)) / (2 * half)) * perp(way.way);
  DyadSolutions result = one(rr_dyad(poses, in_body, middle + across));
  if (square > slack) result.add(rr_dyad(poses, in_body, middle - across));
  return result;
}

DyadSolutions slider_of(std::span<const Pose, 2> poses, const Vec2d& in_body) {
  if (!finite(poses) || !finite(in_body)) return {GuidanceStatus::not_finite, {}, 0};
  const Way way = way_of(poses, in_body);
  if (way.at_rest) return {GuidanceStatus::pivot_at_rest, {}, 0};
  return slider(poses, in_body, way);
}

}  // namespace cognate::synthesis
