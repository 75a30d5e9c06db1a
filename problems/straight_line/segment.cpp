#include "problems/straight_line/segment.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/coupler_curve/straightness.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/zeros.hpp"

namespace cognate::problems {
namespace {

void divide(std::optional<double>& length, double unit) {
  if (length) *length /= unit;
}

void divide(std::optional<Vec2d>& point, double unit) {
  if (point) point = Vec2d{point->x / unit, point->y / unit};
}

void divide(std::optional<Range>& range, double unit) {
  if (range) range = Range{range->min / unit, range->max / unit};
}

void divide(std::optional<Box>& box, double unit) {
  if (!box) return;
  box = Box{{box->min.x / unit, box->min.y / unit}, {box->max.x / unit, box->max.y / unit}};
}

/// Every place of the plane that a problem names.
template <class Move>
void move_places(StraightLineProblem& problem, const Move& move) {
  const auto each = [&](auto& place) {
    if (place) move(*place);
  };
  const auto corners = [&](std::optional<Box>& box) {
    if (!box) return;
    move(box->min);
    move(box->max);
  };
  each(problem.given.pivot_a);
  each(problem.given.pivot_d);
  corners(problem.bounds.pivot_a);
  corners(problem.bounds.pivot_d);
  corners(problem.constraints.pivot_region);
}

double difference(double a, double b) {
  return std::abs(std::remainder(a - b, kTurn));
}

}  // namespace

double largest_dimension(const LinkageSegment& segment) {
  const auto& [links, point] = segment.dimensions;
  const double sides = std::max(norm(point), norm(point - Vec2d{links[1], 0}));
  const double bars = std::max(links[0], links[1]);
  if (segment.type == MechanismType::slider_crank) return std::max(sides, bars);
  return std::max({sides, bars, links[2], links[3]});
}

LinkageSegment enlarged(LinkageSegment segment, double factor) {
  for (double& link : segment.dimensions.links) link *= factor;
  segment.dimensions.point = factor * segment.dimensions.point;
  segment.height *= factor;
  segment.length *= factor;
  return segment;
}

std::optional<double> fit_line(LinkageSegment& segment) {
  const CouplerMotion<double> motion(segment.type, segment.dimensions, sign(segment.assembly));
  const auto path = [&motion](double angle) -> PathPoint {
    const CouplerPoint<double> point = motion.at(angle);
    if (!point.closes) return {{kNaN, kNaN}, {kNaN, kNaN}};
    return {point.at, point.rate};
  };
  constexpr int kCells = 48;
  for (const double place : crowded(segment.from(), segment.to(), kCells)) {
    if (!motion.at(place).closes) return std::nullopt;
  }
  const StraightSegment measured = measure(path, segment.from(), segment.to());
  if (!(measured.length > 0) || !std::isfinite(measured.deviation)) return std::nullopt;
  segment.line = std::atan2(measured.line.direction.y, measured.line.direction.x);
  segment.height = cross(measured.line.direction, measured.line.through);
  segment.length = measured.length;
  return measured.deviation;
}

LinkageSegment in_file_unit(LinkageSegment segment, double unit) {
  segment = enlarged(segment, unit);
  segment.pivot_a = unit * segment.pivot_a;
  return segment;
}

StraightLineProblem in_unit(StraightLineProblem problem, double unit) {
  if (auto& ends = problem.goal->ends) {
    const Vec2d middle = 0.5 * (ends->front() + ends->back());
    move_places(problem, [&middle](Vec2d& place) { place = place - middle; });
    for (Vec2d& end : *ends) end = (1 / unit) * (end - middle);
  }
  for (auto* length : {&problem.goal->length, &problem.goal->deviation, &problem.given.crank,
                       &problem.given.coupler, &problem.given.rocker, &problem.given.frame,
                       &problem.slider_offset}) {
    divide(*length, unit);
  }
  for (auto* point :
       {&problem.given.pivot_a, &problem.given.pivot_d, &problem.given.coupler_point}) {
    divide(*point, unit);
  }
  Bounds& bounds = problem.bounds;
  for (auto* range : {&bounds.crank, &bounds.coupler, &bounds.rocker, &bounds.frame}) {
    divide(*range, unit);
  }
  for (auto* box : {&bounds.pivot_a, &bounds.pivot_d, &bounds.coupler_point,
                    &problem.constraints.pivot_region}) {
    divide(*box, unit);
  }
  return problem;
}

bool has_scale(const StraightLineProblem& problem) {
  const Given& given = problem.given;
  const Bounds& bounds = problem.bounds;
  const bool places = bounds.pivot_a || bounds.pivot_d || problem.constraints.pivot_region;
  return given.crank || given.coupler || given.rocker || given.frame || given.coupler_point ||
         (given.pivot_a && given.pivot_d) || bounds.crank || bounds.coupler || bounds.rocker ||
         bounds.frame || bounds.coupler_point || problem.slider_offset.value_or(0) != 0 ||
         (places && !problem.goal->ends);
}

bool same_segment(const LinkageSegment& a, const LinkageSegment& b, double tolerance) {
  if (a.type != b.type) return false;
  const double size = tolerance * std::max(largest_dimension(a), largest_dimension(b));
  for (std::size_t i = 0; i < 4; ++i) {
    const double own = a.dimensions.links[i], other = b.dimensions.links[i];
    const bool offset = a.type == MechanismType::slider_crank && i == 2;
    const bool mirrored = offset && a.assembly == b.assembly;
    if (std::abs(own - other) > size && !(mirrored && std::abs(own + other) <= size)) return false;
  }
  const Vec2d own = a.dimensions.point, other = b.dimensions.point;
  const bool mirror = a.type == MechanismType::four_bar
                          ? a.assembly != b.assembly
                          : difference(a.centre, -b.centre) < difference(a.centre, b.centre);
  if (norm(own - (mirror ? conj(other) : other)) > size) return false;
  const double centre = mirror ? -b.centre : b.centre;
  constexpr double kFarthestAngle = 0.5;
  const double angle = std::min(30 * tolerance, kFarthestAngle);
  return difference(a.centre, centre) <= angle && std::abs(a.reach - b.reach) <= angle;
}

}  // namespace cognate::problems
