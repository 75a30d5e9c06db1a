#include "problems/straight_line/design.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "analysis/coupler_curve/straightness.hpp"
#include "analysis/numbers/angle.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/basics/quantity_key.hpp"
#include "problems/evaluation/mechanism_metrics.hpp"

namespace cognate::problems {
namespace {

using synthesis::CouplerLinkage;
using synthesis::StraightLineSolution;

constexpr int kCoupler = 2;
constexpr QuantityKey<double> kStraightLengthKey{"straight_length_at_0_001"};

struct Level {
  double relative;
  const char* suffix;
};
constexpr std::array<Level, 2> kLevels{{{1e-3, "at_0_001"}, {1e-2, "at_0_01"}}};

NamedMechanism mechanism_of(const StraightLineSolution& solution) {
  if (const auto* four_bar = std::get_if<FourBar>(&solution.linkage)) {
    FourBar linkage = *four_bar;
    linkage.coupler_point = solution.point.coupler_point;
    return named(linkage);
  }
  NamedMechanism mechanism = named(std::get<SliderCrank>(solution.linkage));
  add_point(mechanism, "P", "coupler", solution.point.coupler_point);
  return mechanism;
}

double longest_link(const CouplerLinkage& linkage) {
  if (const auto* slider = std::get_if<SliderCrank>(&linkage)) {
    return std::max(slider->crank, slider->coupler);
  }
  const Lengths<double> links = lengths(std::get<FourBar>(linkage));
  return std::max({links.crank, links.coupler, links.rocker, links.frame});
}

void add(Metrics& metrics, const std::string& name, double value) {
  if (std::isfinite(value)) metrics.quantities.push_back({name, value});
}

void add_segment(Metrics& metrics, const Path& path, const StraightSegment& segment,
                 const char* suffix) {
  const auto named = [suffix](const char* what) { return fmt::format("{}_{}", what, suffix); };
  add(metrics, named("straight_length"), segment.length);
  if (!(segment.length > 0)) return;
  const Vec2d& along = segment.line.direction;
  add(metrics, named("deviation"), segment.deviation);
  add(metrics, named("direction_deg"), degrees(std::atan2(along.y, along.x)));
  add(metrics, named("crank_from_deg"), degrees(segment.from));
  add(metrics, named("crank_to_deg"), degrees(segment.to));
  const auto variation = speed_variation(path, segment);
  if (variation) add(metrics, named("speed_variation"), *variation);
}

/// The segments at each level; empty where the motion ends at the position itself.
std::vector<StraightSegment> segments(const StraightLineSolution& solution, const Path& path) {
  std::vector<StraightSegment> found;
  const auto limits = synthesis::range_about(solution.linkage, solution.crank_angle);
  if (!limits) return found;
  const auto forward = forward_interval(path, solution.crank_angle, *limits);
  if (!forward) return found;
  for (const Level& level : kLevels) {
    found.push_back(longest_segment(path, solution.crank_angle, *forward, level.relative));
  }
  return found;
}

/// Over the longer segment.
Metrics metrics_of(const NamedMechanism& mechanism, double position,
                   const std::vector<StraightSegment>& straight) {
  const std::vector<double> sides = cognate::sides(mechanism.mechanism);
  std::vector<DriveState> states{{position, sides}};
  if (!straight.empty()) {
    states.push_back({straight.back().from, sides});
    states.push_back({straight.back().to, sides});
  }
  return mechanism_metrics(mechanism, states, PointOrder::any);
}

}  // namespace

Design straight_line_design(const StraightLineProblem& problem,
                            const synthesis::StraightLineSolution& solution) {
  Design design;
  design.mechanism = mechanism_of(solution);
  const Path path = path_of(design.mechanism.mechanism, {kCoupler, solution.point.coupler_point});
  const auto straight = segments(solution, path);
  design.crank_angles = {in_one_turn(solution.crank_angle)};
  design.origin = fmt::format("exact:{}", synthesis::name(solution.point.kind));
  Metrics& metrics = design.metrics;
  metrics = metrics_of(design.mechanism, solution.crank_angle, straight);
  metrics.precision_residual = solution.point.contact.residual;
  if (std::isfinite(solution.point.condition)) metrics.condition = solution.point.condition;
  metrics.quantities.push_back({"contact_points", double(solution.point.contact.points)});
  for (std::size_t i = 0; i < straight.size(); ++i) {
    add_segment(metrics, path, straight[i], kLevels[i].suffix);
  }
  add(metrics, "straight_length_over_longest_link",
      straight_length(design) / longest_link(solution.linkage));
  design.constraints = check_constraints(problem.constraints, {}, design.mechanism, metrics);
  return design;
}

double straight_length(const Design& design) {
  return find_quantity(design.metrics.quantities, kStraightLengthKey).value_or(0);
}

}  // namespace cognate::problems
