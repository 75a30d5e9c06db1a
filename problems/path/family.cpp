#include <algorithm>
#include <cmath>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/random.hpp"
#include "problems/path/exact/designs.hpp"
#include "problems/path/exact/solve.hpp"
#include "synthesis/exact/nine_point/constrained_path.hpp"

namespace cognate::problems {
namespace {

Box box_of(const std::vector<Vec2d>& points) {
  Box box{points[0], points[0]};
  for (const Vec2d& p : points) {
    box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y)};
    box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y)};
  }
  return box;
}

/// The greater side of the path's box; of a path that is one point a given length, or 1.
double size_of(const PathProblem& problem) {
  const Box path = box_of(problem.points);
  const double size = std::max(path.max.x - path.min.x, path.max.y - path.min.y);
  if (size > 0) return size;
  const Given& given = problem.given;
  double longest = 0;
  for (const auto& length : {given.crank, given.coupler, given.rocker, given.frame}) {
    longest = std::max(longest, length.value_or(0));
  }
  for (const auto& pivot : {given.pivot_a, given.pivot_d}) {
    if (pivot) longest = std::max(longest, norm(*pivot - problem.points[0]));
  }
  return longest > 0 ? longest : 1;
}

/// A place about the path.
Box around(const PathProblem& problem) {
  const Box path = box_of(problem.points);
  const Vec2d middle = 0.5 * (path.min + path.max);
  const double reach = 2 * size_of(problem);
  return {middle - Vec2d{reach, reach}, middle + Vec2d{reach, reach}};
}

/// The limits where they are finite; for a side without limit that of `about`, or as far from the
/// other side as `about` is wide where that is beyond it.
Range finite(const Range& limits, const Range& about) {
  Range range = limits;
  const double width = about.max - about.min;
  if (!std::isfinite(range.min)) {
    range.min = about.min < limits.max ? about.min : limits.max - width;
  }
  if (!std::isfinite(range.max)) {
    range.max = about.max > range.min ? about.max : range.min + width;
  }
  return range;
}

/// Where a pivot may be: within its bounds and the region of pivots, and about the path as far as
/// they leave it free.
Box pivot_box(const PathProblem& problem, const std::optional<Box>& bounds) {
  const Box about = around(problem);
  Box box{{-kInfinity, -kInfinity}, {kInfinity, kInfinity}};
  for (const auto& limits : {bounds, problem.constraints.pivot_region}) {
    if (!limits) continue;
    box.min = {std::max(box.min.x, limits->min.x), std::max(box.min.y, limits->min.y)};
    box.max = {std::min(box.max.x, limits->max.x), std::min(box.max.y, limits->max.y)};
  }
  const Range x = finite({box.min.x, box.max.x}, {about.min.x, about.max.x});
  const Range y = finite({box.min.y, box.max.y}, {about.min.y, about.max.y});
  return {{x.min, y.min}, {x.max, y.max}};
}

Vec2d direction(std::mt19937_64& random) {
  const double angle = uniform(random, -kPi, kPi);
  return unit_vector(angle);
}

Vec2d point_in(const Box& box, std::mt19937_64& random) {
  const double x = uniform(random, box.min.x, box.max.x);
  return {x, uniform(random, box.min.y, box.max.y)};
}

/// A point of the closed curve of Catmull and Rom through the problem's points, off it by a little.
Vec2d point_of_curve(const PathProblem& problem, std::mt19937_64& random) {
  const std::vector<Vec2d>& points = problem.points;
  const std::size_t count = points.size();
  const std::size_t i = std::uniform_int_distribution<std::size_t>(0, count - 1)(random);
  const Vec2d &p0 = points[(i + count - 1) % count], &p1 = points[i];
  const Vec2d &p2 = points[(i + 1) % count], &p3 = points[(i + 2) % count];
  const double t = uniform(random, 0.25, 0.75);
  const Vec2d m1 = 0.5 * (p2 - p0), m2 = 0.5 * (p3 - p1), chord = p2 - p1;
  const double u = 1 - t;
  const Vec2d on =
      u * u * (1 + 2 * t) * p1 + t * t * (3 - 2 * t) * p2 + t * u * u * m1 - t * t * u * m2;
  // Two poses at one place, about which the curve may go anywhere.
  if (p1 == p2) return on + size_of(problem) * uniform(random, 0.2, 0.6) * direction(random);
  // Through two points there is a circle on any side.
  const double off = count < 3 ? uniform(random, 0.2, 0.6) : uniform(random, -0.05, 0.05);
  return on + off * perp(chord);
}

/// Chooses both pivots, as far as they are free.
synthesis::FixedParts with_pivots(const PathProblem& problem, std::mt19937_64& random) {
  synthesis::FixedParts parts = given_parts(problem.given);
  const auto choose = [&](std::optional<Vec2d>& pivot, const std::optional<Box>& bounds) {
    if (!pivot) pivot = point_in(pivot_box(problem, bounds), random);
  };
  const bool frame = parts.frame || parts.frame_angle;
  const bool neither = !parts.pivot_a && !parts.pivot_d;
  if (!frame || neither) choose(parts.pivot_a, problem.bounds.pivot_a);
  if (!frame) choose(parts.pivot_d, problem.bounds.pivot_d);
  if (frame && !(parts.pivot_a && parts.pivot_d)) {
    const Vec2d any = direction(random);
    if (!parts.frame_angle) parts.frame_angle = std::atan2(any.y, any.x);
    if (!parts.frame) parts.frame = size_of(problem) * uniform(random, 0.5, 2);
  }
  return synthesis::without_repetition(parts);
}

}  // namespace

FamilyMember random_member(const PathProblem& problem, int free, std::mt19937_64& random) {
  FamilyMember member{positions_of(problem), given_parts(problem.given)};
  const synthesis::FixedParts chosen = with_pivots(problem, random);
  const int added = condition_count(chosen) - condition_count(member.parts);
  int missing = free;
  if (added <= free && are_independent(synthesis::class_of(member.positions), chosen)) {
    member.parts = chosen;
    missing -= added;
  }
  for (; missing > 0; --missing) {
    member.positions.push_back({point_of_curve(problem, random), {}});
  }
  return member;
}

}  // namespace cognate::problems
