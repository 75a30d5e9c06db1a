#include "problems/straight_line/normalised.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "analysis/coupler_curve/straightness.hpp"
#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/evaluation/mechanism_metrics.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/search/solver_origin.hpp"
#include "problems/straight_line/model.hpp"
#include "problems/straight_line/placing.hpp"
#include "synthesis/optimise/solver.hpp"

namespace cognate::problems {
namespace {

constexpr int kCouplerLink = 2;

NamedMechanism mechanism_of(const StraightLineProblem& problem, const LinkageSegment& segment) {
  const auto& [links, point] = segment.dimensions;
  const Vec2d along = unit_vector(segment.frame_angle), a = segment.pivot_a;
  if (segment.type == MechanismType::slider_crank) {
    NamedMechanism mechanism =
        named(SliderCrank{a, links[0], links[1], links[2], along, segment.assembly});
    add_point(mechanism, "P", "coupler", point);
    return mechanism;
  }
  const bool pivots = problem.given.pivot_a && problem.given.pivot_d;
  const Vec2d d = pivots ? *problem.given.pivot_d : a + links[3] * along;
  return named(FourBar{a, d, links[0], links[1], links[2], segment.assembly, point});
}

double longest_link(const LinkageSegment& segment) {
  const auto& links = segment.dimensions.links;
  const bool slides = segment.type == MechanismType::slider_crank;
  return std::max({links[0], links[1], slides ? 0.0 : links[2], slides ? 0.0 : links[3]});
}

/// The diagonal of the box along the line that holds B and C over the segment.
double box_diagonal(const LinkageSegment& found, const StraightSegment& straight) {
  const CouplerMotion<double> motion(found.type, found.dimensions, sign(found.assembly));
  const Vec2d back = conj(unit_vector(
      std::atan2(straight.line.direction.y, straight.line.direction.x) - found.frame_angle));
  constexpr int kCells = 720;
  Vec2d low{1e300, 1e300}, high{-1e300, -1e300};
  for (int k = 0; k <= kCells; ++k) {
    const auto point = motion.at(found.from() + 2 * found.reach * k / kCells);
    if (!point.closes) continue;
    for (const Vec2d& pivot : {point.pin, point.joint}) {
      const Vec2d at = back * pivot;
      low = {std::min(low.x, at.x), std::min(low.y, at.y)};
      high = {std::max(high.x, at.x), std::max(high.y, at.y)};
    }
  }
  return norm(high - low);
}

/// Infinite where the design has no such quantity, so that no limit on it is met.
double quantity_of(const Design& design, const QuantityKey<double>& key) {
  return find_quantity(design.metrics.quantities, key).value_or(kInfinity);
}

/// Collects the checks of a segment.
class SegmentChecks {
 public:
  explicit SegmentChecks(Design& design) : design_(design) {}

  void at_most(const char* name, double value, const std::optional<double>& most) {
    if (!most) return;
    add(name, value, Range{0, *most}, value <= *most * (1 + kSegmentTolerance));
  }
  void equal(const char* name, double value, const std::optional<double>& wanted) {
    if (!wanted) return;
    const bool met = std::abs(value - *wanted) <= kSegmentTolerance * *wanted;
    design_.constraints.push_back({name, value, *wanted, met});
  }
  /// Of the feet of the path's ends, of a line of that length.
  void ends(double distance, double length) {
    const Range range{0, kSegmentTolerance * length};
    add("target.ends", distance, range, distance <= range.max);
  }
  void within(const char* name, double value, const Range& range) {
    const double slack = kSegmentTolerance * range.max;
    add(name, value, range, value >= range.min - slack && value <= range.max + slack);
  }
  /// Of a line, either way along it.
  void direction(double value, double wanted) {
    const double off = std::remainder(value - wanted, kPi);
    design_.constraints.push_back({"target.direction_deg", degrees(wanted + off), degrees(wanted),
                                   std::abs(off) <= kSegmentTolerance, std::abs(off)});
  }

 private:
  void add(const char* name, double value, const Range& range, bool met) {
    design_.constraints.push_back({name, value, range, met});
  }

  Design& design_;
};

void add_checks(const StraightLineProblem& problem, const Path& path,
                const StraightSegment& straight, Design& design) {
  const StraightLineGoal& goal = *problem.goal;
  const SegmentConstraints& limits = problem.segment;
  SegmentChecks checks(design);
  if (goal.ends) {
    checks.ends(distance_from_ends(problem, path, straight), *goal.length);
  } else {
    checks.equal("target.length", straight.length, goal.length);
  }
  checks.at_most("target.deviation", straight.deviation, goal.deviation);
  checks.at_most("target.deviation_relative", straight.deviation / straight.length,
                 goal.deviation_relative);
  const Vec2d& along = straight.line.direction;
  if (goal.direction) checks.direction(std::atan2(along.y, along.x), *goal.direction);
  if (limits.crank_range) {
    checks.within("crank_range_deg", degrees(straight.to - straight.from),
                  {degrees(limits.crank_range->min), degrees(limits.crank_range->max)});
  }
  const double size = size_limit(problem);
  if (size < 1e3) {
    checks.at_most("size_over_length_max", quantity_of(design, kSizeOverLengthKey), size);
  }
  checks.at_most("speed_variation_max", quantity_of(design, kSpeedVariationKey),
                 limits.speed_variation_max);
}

void add_quantities(const LinkageSegment& found, const Path& path, const StraightSegment& straight,
                    Metrics& metrics) {
  const auto add = [&](const auto& key, double value) {
    if (std::isfinite(value)) metrics.quantities.push_back(quantity(key, value));
  };
  using Key = QuantityKey<double>;
  const Vec2d& along = straight.line.direction;
  add(kSegmentLengthKey, straight.length);
  add(kDeviationKey, straight.deviation);
  add(Key{"deviation_relative"}, straight.deviation / straight.length);
  add(kSegmentFromKey, straight.from);
  add(kSegmentToKey, straight.to);
  add(kLineDirectionKey, std::atan2(along.y, along.x));
  if (const auto variation = speed_variation(path, straight)) add(kSpeedVariationKey, *variation);
  add(kSizeOverLengthKey, largest_dimension(found) / straight.length);
  add(Key{"straight_length_over_longest_link"}, straight.length / longest_link(found));
  add(Key{"straight_length_over_box"}, straight.length / box_diagonal(found, straight));
}

}  // namespace

Design searched_design(const StraightLineProblem& problem, const SegmentDesign& found) {
  const LinkageSegment segment = in_file_plane(problem, found.segment);
  Design design;
  design.mechanism = mechanism_of(problem, segment);
  const Path path = path_of(design.mechanism.mechanism, {kCouplerLink, segment.dimensions.point});
  const double turns = kTurn * std::floor((segment.from() + segment.frame_angle + 1e-12) / kTurn);
  const double from = segment.from() + segment.frame_angle - turns;
  const double to = segment.to() + segment.frame_angle - turns;
  const StraightSegment straight = measured(problem, path, from, to);
  design.crank_angles = {in_one_turn(from), in_one_turn(to)};
  const std::vector<double> sides = cognate::sides(design.mechanism.mechanism);
  const std::array<DriveState, 3> states{
      DriveState{from, sides}, DriveState{0.5 * (from + to), sides}, DriveState{to, sides}};
  design.metrics = mechanism_metrics(design.mechanism, states, PointOrder::any);
  add_quantities(segment, path, straight, design.metrics);
  if (design.mechanism.four_bar()) {
    design.constraints = check_constraints(problem.constraints, problem.bounds, problem.given,
                                           *design.mechanism.four_bar(), design.metrics);
  } else {
    design.constraints =
        check_constraints(problem.constraints, problem.bounds, design.mechanism, design.metrics);
  }
  add_checks(problem, path, straight, design);
  design.metrics.quantities.push_back({"start_family", found.origin});
  const auto begun = synthesis::Solver::gauss_newton, last = last_solver(problem);
  design.origin = fmt::format("search + {}", synthesis::name(begun));
  if (last != begun) design.origin += fmt::format(" + {}", synthesis::name(last));
  return design;
}

SegmentMeasures measures_of(const Design& design) {
  return {quantity_of(design, kSegmentLengthKey), quantity_of(design, kDeviationKey),
          quantity_of(design, kSizeOverLengthKey)};
}

}  // namespace cognate::problems
