#include "problems/straight_line/read_search.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <string_view>

#include "analysis/numbers/constants.hpp"
#include "problems/layers/link_names.hpp"
#include "problems/linkage/design_layers.hpp"
#include "problems/linkage/read_constraints.hpp"
#include "problems/linkage/read_linkage.hpp"
#include "problems/straight_line/keys.hpp"
#include "problems/straight_line/read_ends.hpp"
#include "problems/straight_line/read_raster.hpp"
#include "problems/straight_line/segment.hpp"
#include "problems/tolerance/read.hpp"

namespace cognate::problems::reading {
namespace {

/// Links in a ratio beyond this make linkages of paper; a file may say otherwise.
constexpr double kLinkRatio = 10;
/// What `constant_velocity` allows the speed to vary by where the file says nothing.
constexpr double kSpeedVariation = 0.1;
StraightLineGoal read_goal(TableReader& target) {
  StraightLineGoal goal;
  read_keys(target, kGoalKeys, goal);
  read_ends(target, goal);
  if (target.has("deviation") && target.has("deviation_relative")) {
    target.fault("deviation_relative",
                 "is given beside deviation; give the one in units of length or the other");
  }
  if (goal.length && goal.deviation && *goal.deviation > 0.1 * *goal.length) {
    target.fault("deviation", fmt::format("is {}, more than a tenth of the length {}; expected a "
                                          "smaller one, such a segment is no line",
                                          *goal.deviation, *goal.length));
  }
  if (target.has("contact")) {
    target.fault("contact", "is of method = \"exact\"; add that or remove it");
  }
  return goal;
}

void read_four_bar(TableReader& mechanism, TableReader& bounds, StraightLineProblem& problem) {
  read_given_links(mechanism, problem.given);
  read_given_places(mechanism, problem.given);
  read_length_bounds(bounds, problem.bounds);
  read_place_bounds(bounds, problem.bounds);
  check_given(mechanism, problem.given, problem.bounds);
}

void read_slider_crank(TableReader& mechanism, TableReader& bounds, StraightLineProblem& problem) {
  Given& given = problem.given;
  given.crank = mechanism.number("crank", kLinkLength);
  given.coupler = mechanism.number("coupler", kLinkLength);
  given.assembly = mechanism.choice<Assembly>("assembly");
  given.pivot_a = mechanism.point("pivot");
  given.coupler_point = mechanism.point("coupler_point");
  problem.slider_offset = mechanism.number("offset", kQuantity);
  const auto direction = mechanism.number("direction_deg", kAngle);
  if (direction) given.frame_angle = radians(*direction);
  read_length_bounds(bounds, problem.bounds);
  problem.bounds.coupler_point = bounds.box("coupler_point");
  for (const std::string_view key : {"rocker", "frame"}) {
    if (!bounds.has(key)) continue;
    bounds.fault(key, "limits a link that a slider-crank does not have; remove it");
  }
  check_given(mechanism, given, problem.bounds);
}

/// Where the one pivot of a slider-crank stands, and which way its slide line goes, is open unless
/// the line has a place.
void read_region(TableReader& constraints, StraightLineProblem& problem) {
  const bool slides = problem.type == MechanismType::slider_crank;
  if (slides && !problem.goal->ends && constraints.has("pivot_region")) {
    constraints.fault("pivot_region",
                      "is given for a line without a place; add target.ends, or remove it");
    return;
  }
  read_pivot_region(constraints, problem.given, problem.constraints);
}

SegmentConstraints read_segment_keys(TableReader& constraints, bool constant_velocity) {
  SegmentConstraints segment;
  read_keys(constraints, kSegmentKeys, segment);
  if (constant_velocity && !segment.speed_variation_max) {
    segment.speed_variation_max = kSpeedVariation;
  }
  return segment;
}

/// Whether the lengths given and bounded leave linkages of that ratio.
bool allows_usual_ratio(const StraightLineProblem& problem) {
  const LengthLimits limits = length_limits(problem.given, problem.bounds);
  double longest = 0, shortest = kInfinity;
  for (const Range& limit : limits) {
    longest = std::max(longest, limit.min);
    shortest = std::min(shortest, limit.max);
  }
  return longest <= kLinkRatio * shortest;
}

/// Without a scale a linkage twice as large has twice the segment with twice the deviation.
void check_scale(TableReader& target, const StraightLineProblem& problem) {
  const StraightLineGoal& goal = *problem.goal;
  if (!goal.deviation || goal.length || has_scale(problem)) return;
  target.fault(
      "deviation",
      "is a length, and nothing in the file fixes the linkage's size, so that no segment is "
      "the longest; add length, a bound or a dimension, or give deviation_relative");
}

constexpr std::string_view kFrontOfLines =
    "is given without length and deviation, but the designs of a front are the best for any number "
    "of layers; expected one of them in [target]";

}  // namespace

StraightLineProblem read_straight_line_search(TableReader& document) {
  StraightLineProblem problem;
  LinkageTables tables(document);
  auto& [target, mechanism, bounds, constraints, solve] = tables;

  target.know({"method"});
  problem.goal = read_goal(target);
  const bool constant_velocity = target.boolean("constant_velocity").value_or(false);
  constexpr std::string_view kTypes[] = {"four-bar", "slider-crank"};
  const bool slides = mechanism.choice_of("type", kTypes).value_or(0) == 1;
  if (slides) {
    problem.type = MechanismType::slider_crank;
    read_slider_crank(mechanism, bounds, problem);
  } else {
    read_four_bar(mechanism, bounds, problem);
  }
  read_link_constraints(constraints, length_limits(problem.given, problem.bounds),
                        problem.constraints);
  if (!constraints.has("link_ratio_max") && allows_usual_ratio(problem)) {
    problem.constraints.link_ratio_max = kLinkRatio;
  }
  read_region(constraints, problem);
  problem.segment = read_segment_keys(constraints, constant_velocity);
  check_scale(target, problem);
  problem.solve = read_solve(solve, problem.constraints, false);
  const StraightLineGoal& goal = *problem.goal;
  const bool front = !goal.length && !goal.deviation && !goal.deviation_relative;
  constexpr int kAlongFront = 12;
  if (front && !solve.has("designs")) problem.solve.designs = kAlongFront;

  problem.layers = read_design_layers(document, constraints,
                                      slides ? links_of<SliderCrank>() : links_of<FourBar>(),
                                      front ? kFrontOfLines : layers_max_refusal(problem.solve));
  problem.tolerances = read_tolerances(document, slides ? slider_crank_scope() : four_bar_scope());
  read_straight_line_raster(document, problem);
  tables.finish();
  return problem;
}

}  // namespace cognate::problems::reading
