#include "problems/path/shape_placement.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/numbers/constants.hpp"

namespace cognate::problems {
namespace {

Range limits(const std::optional<double>& given, const std::optional<Range>& bounds) {
  if (given) return {*given, *given};
  return bounds.value_or(Range{0, kInfinity});
}

/// Direction and distance from A to D where the file gives both.
std::optional<Vec2d> given_frame(const Given& given) {
  if (!given.pivot_a || !given.pivot_d) return std::nullopt;
  return *given.pivot_d - *given.pivot_a;
}

std::array<Range, 4> placed_length_limits(const PathProblem& problem) {
  const Given& given = problem.given;
  const Bounds& bounds = problem.bounds;
  const auto between = given_frame(given);
  const auto frame = between ? std::optional(norm(*between)) : given.frame;
  return {limits(given.crank, bounds.crank), limits(given.coupler, bounds.coupler),
          limits(given.rocker, bounds.rocker), limits(frame, bounds.frame)};
}

/// The factor nearest to 1 that brings all lengths within their limits; where there is none, as
/// rounding may have it, the middle of those that single links want.
double scale_of(const std::array<Range, 4>& limits, const Lengths<double>& links) {
  const std::array<double, 4> lengths{links.crank, links.coupler, links.rocker, links.frame};
  double least = 0, greatest = kInfinity;
  for (std::size_t i = 0; i < limits.size(); ++i) {
    least = std::max(least, limits[i].min / lengths[i]);
    greatest = std::min(greatest, limits[i].max / lengths[i]);
  }
  return least <= greatest ? std::clamp(1.0, least, greatest) : least * std::sqrt(greatest / least);
}

/// The least turn that brings the frame's direction `angle` to what the file wants.
double turn_of(const PathProblem& problem, double angle) {
  const auto between = given_frame(problem.given);
  const auto wanted =
      between ? std::optional(std::atan2(between->y, between->x)) : problem.given.frame_angle;
  if (wanted) return std::remainder(*wanted - angle, kTurn);
  if (!problem.bounds.frame_angle) return 0;
  const Range& range = *problem.bounds.frame_angle;
  const double to_min = std::remainder(range.min - angle, kTurn);
  const double to_max = to_min + (range.max - range.min);
  // Within the range already, or so after a whole turn.
  if (to_min <= 0 && to_max >= 0) return 0;
  if (to_max >= kTurn) return 0;
  const double down = to_max > 0 ? to_max - kTurn : to_max;
  return std::abs(to_min) <= std::abs(down) ? to_min : down;
}

}  // namespace

bool is_movable(const PathProblem& problem) {
  return problem.curve && problem.curve->place == CurvePlace::similar;
}

PathProblem normalised(const PathProblem& problem) {
  PathProblem searched = problem;
  searched.curve.reset();  // models keep a copy of their problem, and it may have many vertices
  if (!is_movable(problem)) return searched;
  const auto limits = placed_length_limits(problem);
  const bool limited = std::ranges::any_of(
      limits, [](const Range& range) { return range.min > 0 || range.max < kInfinity; });
  if (limited) searched.constraints.proportions = limits;
  searched.given = {};
  searched.given.assembly = problem.given.assembly;
  searched.bounds = {};
  return searched;
}

CurvePlacement placement_of(const PathProblem& problem, const FourBar& linkage) {
  const double angle = frame_angle(linkage);
  CurvePlacement placement{
      scale_of(placed_length_limits(problem), lengths(linkage)), turn_of(problem, angle), {}};
  if (problem.given.pivot_a) {
    placement.shift = *problem.given.pivot_a - placement.vector(linkage.pivot_a);
  } else if (problem.given.pivot_d) {
    placement.shift = *problem.given.pivot_d - placement.vector(linkage.pivot_d);
  }
  return placement;
}

FourBar placed(const PathProblem& problem, const FourBar& linkage,
               const CurvePlacement& placement) {
  const Given& given = problem.given;
  FourBar there = linkage;
  there.crank = given.crank.value_or(placement.scale * linkage.crank);
  there.coupler = given.coupler.value_or(placement.scale * linkage.coupler);
  there.rocker = given.rocker.value_or(placement.scale * linkage.rocker);
  there.pivot_a = given.pivot_a.value_or(placement.point(linkage.pivot_a));
  there.pivot_d = given.pivot_d.value_or(placement.point(linkage.pivot_d));
  there.coupler_point = placement.scale * linkage.coupler_point.value_or(Vec2d{});
  return there;
}

}  // namespace cognate::problems
