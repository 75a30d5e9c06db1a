#include "problems/straight_line/placing.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/zeros.hpp"

namespace cognate::problems {
namespace {

Vec2d middle_of(const StraightLineProblem& problem) {
  return 0.5 * (problem.goal->ends->front() + problem.goal->ends->back());
}

Vec2d way_of(const StraightLineProblem& problem) {
  return problem.goal->ends->back() - problem.goal->ends->front();
}

/// The mirror image in the frame's line: its crank runs the other way, so that the line is traced
/// from its other end as the crank's angle grows.
LinkageSegment mirrored(LinkageSegment segment) {
  if (segment.type == MechanismType::slider_crank) {
    segment.dimensions.links[2] = -segment.dimensions.links[2];
  } else {
    segment.assembly = segment.assembly == Assembly::open ? Assembly::crossed : Assembly::open;
  }
  segment.dimensions.point = conj(segment.dimensions.point);
  segment.centre = -segment.centre;
  segment.line = kPi - segment.line;
  return segment;
}

bool may_be_mirrored(const StraightLineProblem& problem) {
  const bool slides = problem.type == MechanismType::slider_crank;
  const bool handed =
      slides ? problem.slider_offset.has_value() : problem.given.assembly.has_value();
  return !handed && !problem.given.coupler_point && !problem.bounds.coupler_point;
}

/// About which angle the frame's is to be, whole turns apart.
double usual_frame_angle(const StraightLineProblem& problem) {
  const auto& range = problem.bounds.frame_angle;
  const bool is_bounded = range && std::isfinite(range->min) && std::isfinite(range->max);
  return problem.given.frame_angle.value_or(is_bounded ? 0.5 * (range->min + range->max) : 0);
}

/// Traced from the first end to the second as the crank's angle grows, or from the second.
LinkageSegment placed_along(const StraightLineProblem& problem, LinkageSegment segment,
                            bool is_from_first) {
  const CouplerMotion<double> motion(segment.type, segment.dimensions, sign(segment.assembly));
  const auto first = motion.at(segment.from()), last = motion.at(segment.to());
  if (!first.closes || !last.closes) return segment;
  const Vec2d along = unit_vector(segment.line);
  const double middle = 0.5 * dot(along, first.at + last.at);
  const Vec2d foot = middle * along + segment.height * perp(along);
  const Vec2d way = way_of(problem);
  const double usual = usual_frame_angle(problem);
  const double angle = std::atan2(way.y, way.x) - segment.line + (is_from_first ? 0 : kPi);
  segment.frame_angle = usual + std::remainder(angle - usual, kTurn);
  segment.pivot_a = middle_of(problem) - unit_vector(segment.frame_angle) * foot;
  return segment;
}

Vec2d pivot_d(const LinkageSegment& segment) {
  return segment.pivot_a + segment.dimensions.links[3] * unit_vector(segment.frame_angle);
}

double distance_from(const std::optional<Box>& box, const Vec2d& point) {
  if (!box) return 0;
  const double x = std::max({0.0, box->min.x - point.x, point.x - box->max.x});
  const double y = std::max({0.0, box->min.y - point.y, point.y - box->max.y});
  return std::hypot(x, y);
}

double pivot_violation(const Vec2d& pivot, const std::optional<Vec2d>& given,
                       const std::optional<Box>& bounds, const std::optional<Box>& region) {
  const double off = given ? norm(pivot - *given) : 0;
  return std::max({off, distance_from(bounds, pivot), distance_from(region, pivot)});
}

double frame_violation(const StraightLineProblem& problem, double angle) {
  const auto& given = problem.given.frame_angle;
  const auto& range = problem.bounds.frame_angle;
  const double off = given ? std::abs(std::remainder(angle - *given, kTurn)) : 0;
  return range ? std::max({off, range->min - angle, angle - range->max}) : off;
}

}  // namespace

bool limits_place(const StraightLineProblem& problem) {
  const auto& [given, bounds] = std::tie(problem.given, problem.bounds);
  if (!problem.goal->ends) return false;
  return given.pivot_a || given.pivot_d || given.frame_angle || bounds.pivot_a || bounds.pivot_d ||
         bounds.frame_angle || problem.constraints.pivot_region;
}

double place_violation(const StraightLineProblem& problem, const LinkageSegment& segment) {
  const auto& region = problem.constraints.pivot_region;
  const double frame = frame_violation(problem, segment.frame_angle);
  const double a =
      pivot_violation(segment.pivot_a, problem.given.pivot_a, problem.bounds.pivot_a, region);
  if (segment.type == MechanismType::slider_crank) return std::max(frame, a);
  return std::max(
      {frame, a,
       pivot_violation(pivot_d(segment), problem.given.pivot_d, problem.bounds.pivot_d, region)});
}

LinkageSegment placed(const StraightLineProblem& problem, const LinkageSegment& segment) {
  std::vector<LinkageSegment> places;
  for (const bool is_from_first : {true, false}) {
    places.push_back(placed_along(problem, segment, is_from_first));
    if (!may_be_mirrored(problem)) continue;
    places.push_back(placed_along(problem, mirrored(segment), is_from_first));
  }
  return *std::ranges::min_element(
      places, {}, [&](const LinkageSegment& place) { return place_violation(problem, place); });
}

bool same_place(const LinkageSegment& a, const LinkageSegment& b, double tolerance) {
  const double size = tolerance * std::max(largest_dimension(a), largest_dimension(b));
  return norm(a.pivot_a - b.pivot_a) <= size && norm(pivot_d(a) - pivot_d(b)) <= size;
}

LinkageSegment in_file_plane(const StraightLineProblem& problem, LinkageSegment segment) {
  if (!problem.goal->ends) return segment;
  if (!limits_place(problem)) {
    fit_line(segment);
    return placed_along(problem, segment, true);
  }
  segment.pivot_a = segment.pivot_a + middle_of(problem);
  return segment;
}

StraightSegment measured(const StraightLineProblem& problem, const Path& path, double from,
                         double to) {
  if (!problem.goal->ends) return measure(path, from, to);
  const Vec2d way = way_of(problem), through = middle_of(problem);
  const Vec2d along = (1 / norm(way)) * way;
  const auto height = [&](double q) { return std::abs(cross(along, path(q).at - through)); };
  const auto slope = [&](double q) { return cross(along, path(q).rate); };
  constexpr int kCells = 96;
  double deviation = height(from), before = from;
  for (const double place : crowded(from, to, kCells)) {
    deviation = std::max(deviation, height(place));
    const double low = slope(before), high = slope(place);
    if (before < place && low * high < 0) {
      const double peak = bracket_zero(slope, before, low, place, high).first;
      deviation = std::max(deviation, height(peak));
    }
    before = place;
  }
  const double length = dot(along, path(to).at - path(from).at);
  return {from, to, std::abs(length), deviation, {through, length < 0 ? -along : along}};
}

double distance_from_ends(const StraightLineProblem& problem, const Path& path,
                          const StraightSegment& segment) {
  const double half = 0.5 * norm(way_of(problem));
  const auto place = [&](double q) {
    return dot(segment.line.direction, path(q).at - segment.line.through);
  };
  return std::max(std::abs(place(segment.from) + half), std::abs(place(segment.to) - half));
}

}  // namespace cognate::problems
