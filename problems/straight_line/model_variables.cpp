#include <algorithm>
#include <tuple>
#include <utility>

#include "analysis/numbers/constants.hpp"
#include "problems/straight_line/model.hpp"

namespace cognate::problems {
namespace {

/// In lengths of the segment: shorter links are not sought.
constexpr double kShortest = 1e-3;

Range intersect(Range a, const std::optional<Range>& b) {
  return b ? Range{std::max(a.min, b->min), std::min(a.max, b->max)} : a;
}

std::optional<Range> side(const std::optional<Box>& box, double Vec2d::*axis) {
  if (!box) return std::nullopt;
  return Range{box->min.*axis, box->max.*axis};
}

std::optional<double> side(const std::optional<Vec2d>& point, double Vec2d::*axis) {
  return point ? std::optional(*point.*axis) : std::nullopt;
}

}  // namespace

SegmentObjective objective_of(const StraightLineProblem& problem) {
  const StraightLineGoal& goal = *problem.goal;
  if (!goal.deviation && !goal.deviation_relative) return SegmentObjective::deviation;
  const bool scaled = has_scale(problem) && !goal.length;
  return scaled ? SegmentObjective::length : SegmentObjective::size;
}

bool wants_front(const StraightLineProblem& problem) {
  const StraightLineGoal& goal = *problem.goal;
  return !goal.length && !goal.deviation && !goal.deviation_relative;
}

double size_limit(const StraightLineProblem& problem) {
  if (problem.segment.size_over_length_max) return *problem.segment.size_over_length_max;
  if (wants_front(problem)) return kFrontSizeOverLength;
  return objective_of(problem) == SegmentObjective::size ? kFarthest : kSizeOverLength;
}

void SegmentModel::add_variable(Dimension dimension, std::optional<double> given, Range range,
                                const char* name) {
  if (!given && range.min == range.max) given = range.min;
  if (given) {
    fixed_[dimension] = *given;
    return;
  }
  free_.push_back(dimension);
  variables_.push_back({name, range.min, range.max, 1});
}

void SegmentModel::list_links() {
  const auto& [given, bounds] = std::tie(problem_.given, problem_.bounds);
  const bool slides = type_ == MechanismType::slider_crank;
  const Range any{kShortest, kFarthest}, anywhere{-kFarthest, kFarthest};
  add_variable(crank, given.crank, intersect(any, bounds.crank), "crank");
  add_variable(coupler, given.coupler, intersect(any, bounds.coupler), "coupler");
  if (slides) {
    add_variable(rocker, problem_.slider_offset, anywhere, "offset");
    add_variable(frame, 1.0, any, "frame");
  } else {
    add_variable(rocker, given.rocker, intersect(any, bounds.rocker), "rocker");
    add_variable(frame, given.frame, intersect(any, bounds.frame), "frame");
  }
  add_variable(point_u, side(given.coupler_point, &Vec2d::x),
               intersect(anywhere, side(bounds.coupler_point, &Vec2d::x)), "coupler point u");
  add_variable(point_v, side(given.coupler_point, &Vec2d::y),
               intersect(anywhere, side(bounds.coupler_point, &Vec2d::y)), "coupler point v");
}

void SegmentModel::list_segment(const LinkageSegment& start) {
  const auto& turn = problem_.segment.crank_range;
  const double most = type_ == MechanismType::four_bar ? kTurn / 2 : kTurn / 4;
  Range half{0.005, most};
  if (turn) half = {std::max(0.5 * turn->min, half.min), 0.5 * turn->max};
  add_variable(centre, {}, {start.centre - kTurn / 2, start.centre + kTurn / 2}, "crank angle");
  add_variable(reach, {}, half, "half crank range");
  add_variable(line, {}, {start.line - kTurn / 2, start.line + kTurn / 2}, "line's direction");
  add_variable(height, {}, {-2 * kFarthest, 2 * kFarthest}, "line's height");
  const StraightLineGoal& goal = *problem_.goal;
  const bool free = !goal.length && has_scale(problem_);
  add_variable(length, free ? std::nullopt : std::optional(goal.length.value_or(1.0)),
               {kShortest, kFarthest}, "length");
  const bool sized = objective_ == SegmentObjective::size;
  add_variable(size, sized ? std::nullopt : std::optional(0.0), {kShortest, 2 * kFarthest}, "size");
  const bool timed = problem_.segment.speed_variation_max.has_value();
  add_variable(least_speed, timed ? std::nullopt : std::optional(0.0), {0.0, 1.0}, "minimum speed");
}

void SegmentModel::list_places() {
  const auto& [given, bounds] = std::tie(problem_.given, problem_.bounds);
  const auto& region = problem_.constraints.pivot_region;
  const bool boxed = bounds.pivot_a || bounds.pivot_d || region || has_place_;
  const Range anywhere{-2 * kFarthest, 2 * kFarthest};
  const auto pivot = [&](double Vec2d::*axis) -> std::pair<std::optional<double>, Range> {
    if (given.pivot_a) return {side(given.pivot_a, axis), anywhere};
    if (!boxed && !given.pivot_d) return {0.0, anywhere};
    return {{}, intersect(intersect(anywhere, side(bounds.pivot_a, axis)), side(region, axis))};
  };
  const auto x = pivot(&Vec2d::x), y = pivot(&Vec2d::y);
  add_variable(pivot_x, x.first, x.second, "pivot x");
  add_variable(pivot_y, y.first, y.second, "pivot y");
  const bool turns = boxed || direction_ || bounds.frame_angle || given.pivot_d;
  const auto angle = given.frame_angle || turns ? given.frame_angle : std::optional(0.0);
  add_variable(frame_angle, angle, intersect({-2 * kTurn, 2 * kTurn}, bounds.frame_angle),
               "frame angle");
}

FourBarPlaces SegmentModel::places() const {
  FourBarPlaces places;
  places.fill(-1);
  for (std::size_t i = 0; i < free_.size(); ++i) {
    if (free_[i] <= point_v) places[static_cast<std::size_t>(free_[i])] = static_cast<int>(i);
  }
  return places;
}

std::vector<double> SegmentModel::variables_of(const LinkageSegment& segment) const {
  All all{};
  const auto& [links, point] = segment.dimensions;
  std::ranges::copy(links, all.begin());
  all[point_u] = point.x;
  all[point_v] = point.y;
  all[centre] = segment.centre;
  all[reach] = segment.reach;
  all[line] = segment.line;
  all[height] = segment.height;
  all[length] = segment.length;
  all[pivot_x] = segment.pivot_a.x;
  all[pivot_y] = segment.pivot_a.y;
  all[frame_angle] = segment.frame_angle;
  all[size] = largest_dimension(segment);
  all[least_speed] = 1 - 0.5 * problem_.segment.speed_variation_max.value_or(0);
  std::vector<double> x;
  for (std::size_t i = 0; i < free_.size(); ++i) {
    x.push_back(std::clamp(all[free_[i]], variables_[i].lower, variables_[i].upper));
  }
  return x;
}

SegmentModel::All SegmentModel::dimensions(std::span<const double> x) const {
  All all = fixed_;
  for (std::size_t i = 0; i < free_.size(); ++i) all[free_[i]] = x[i];
  return all;
}

LinkageSegment SegmentModel::segment(std::span<const double> x) const {
  const All at = dimensions(x);
  LinkageSegment found;
  found.type = type_;
  found.assembly = assembly_ > 0 ? Assembly::open : Assembly::crossed;
  found.dimensions = {{at[crank], at[coupler], at[rocker], at[frame]}, {at[point_u], at[point_v]}};
  found.centre = at[centre];
  found.reach = at[reach];
  found.line = at[line];
  found.height = at[height];
  found.length = at[length];
  found.pivot_a = {at[pivot_x], at[pivot_y]};
  found.frame_angle = at[frame_angle];
  return found;
}

}  // namespace cognate::problems
