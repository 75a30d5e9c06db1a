#include "app/report/report_data.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "analysis/coupler_curve/straightness.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/zeros.hpp"
#include "app/report/design_drawing.hpp"
#include "app/report/drawn_findings.hpp"
#include "app/report/function_trace.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;

ordered_json point_json(const Vec2d& point) {
  return {point.x, point.y};
}

ordered_json rounded_degrees(const std::vector<double>& angles) {
  ordered_json list = ordered_json::array();
  for (const double angle : angles) {
    list.push_back(round_to_digits(kDegreesInRadian * angle, kDrawnDigits));
  }
  return list;
}

ordered_json trace_json(const FunctionTrace& trace) {
  ordered_json x = ordered_json::array();
  for (const double value : trace.x) x.push_back(round_to_digits(value, kDrawnDigits));
  return {{"x", trace.x.empty() ? ordered_json(nullptr) : x},
          {"crank_deg", rounded_degrees(trace.crank)},
          {"error_deg", rounded_degrees(trace.error)}};
}

ordered_json poses_json(const std::vector<synthesis::Pose>& poses) {
  ordered_json list = ordered_json::array();
  for (const auto& pose : poses) {
    list.push_back(ordered_json::array({pose.at.x, pose.at.y, kDegreesInRadian * pose.angle}));
  }
  return list;
}

/// Whether the curve turns by more than some degrees at a vertex.
bool is_corner(const std::vector<Vec2d>& all, std::size_t k) {
  constexpr double kTangent = 0.1;
  const Vec2d before = all[k] - all[(k + all.size() - 1) % all.size()];
  const Vec2d after = all[(k + 1) % all.size()] - all[k];
  return !(std::abs(cross(before, after)) <= kTangent * dot(before, after));
}

/// Vertices of a closed curve, of very many some: corners, and others in even steps.
ordered_json drawn_curve(const problems::ClosedCurve& curve) {
  constexpr std::size_t kMostDrawn = 1000;
  const auto& all = curve.vertices();
  const std::size_t step = (all.size() + kMostDrawn - 1) / kMostDrawn;
  std::size_t corners = 0;
  for (std::size_t k = 0; k < all.size(); ++k) corners += is_corner(all, k);
  ordered_json vertices = ordered_json::array();
  for (std::size_t k = 0; k < all.size(); ++k) {
    const bool kept = corners <= kMostDrawn && is_corner(all, k);
    if (kept || k % step == 0) vertices.push_back(point_json(all[k]));
  }
  return vertices;
}

ordered_json pairs_json(const std::vector<synthesis::AnglePair>& pairs) {
  ordered_json list = ordered_json::array();
  for (const auto& pair : pairs) list.push_back(ordered_json::array({pair.input, pair.output}));
  return list;
}

/// What a function generator is to do, for whoever evaluates another design: increments of both
/// angles in radians where the error counts and over the domain, the ends of the motion, and those
/// of x (null for pairs).
ordered_json wanted_function(const problems::FunctionProblem& problem) {
  if (problem.type != problems::MechanismType::four_bar) return {{"kind", "function"}};
  const auto wanted = problems::function_samples(problem);
  const auto* function = std::get_if<problems::FunctionOfX>(&problem.target);
  ordered_json x;
  if (function) x = {function->domain.min, function->domain.max};
  return {{"kind", "function"},
          {"samples", pairs_json(wanted.samples)},
          {"range", pairs_json(wanted.range)},
          {"sweep", {wanted.sweep.min, wanted.sweep.max}},
          {"x", x}};
}

struct TargetJson {
  ordered_json operator()(const problems::PathProblem& problem) const {
    ordered_json points = ordered_json::array();
    for (const Vec2d& point : problem.points) points.push_back(point_json(point));
    ordered_json target = {{"kind", "path"}, {"points", points}};
    if (problem.curve) target["curve"] = drawn_curve(problem.curve->curve);
    return target;
  }
  ordered_json operator()(const problems::FunctionProblem& problem) const {
    return wanted_function(problem);
  }
  ordered_json operator()(const problems::MotionProblem& problem) const {
    return {{"kind", "motion"}, {"poses", poses_json(problem.poses)}};
  }
  ordered_json operator()(const problems::QuickReturnProblem&) const {
    return {{"kind", "quick-return"}};
  }
  ordered_json operator()(const problems::StraightLineProblem&) const {
    return {{"kind", "straight-line"}};
  }
};

/// The distances of the curve from the line that was sought, and the places along it: finer than
/// the positions drawn can tell. Null without such a stretch.
ordered_json deviation_json(const problems::Design& design) {
  const auto fact = [&](const char* name) {
    const auto found = std::ranges::find(design.metrics.facts, name, &problems::Fact::name);
    return found == design.metrics.facts.end() ? std::numeric_limits<double>::quiet_NaN()
                                               : std::get<double>(found->value);
  };
  const double from = fact("crank_from_deg") / kDegreesInRadian,
               to = fact("crank_to_deg") / kDegreesInRadian;
  const auto& points = design.mechanism.points;
  if (!std::isfinite(from) || !std::isfinite(to) || points.empty()) return nullptr;
  const Path path = path_of(design.mechanism.mechanism, points.back().at);
  const Line line = measure(path, from, to).line;
  const Vec2d start = path(from).at;
  std::vector<double> along, across;
  for (const double crank : crowded(from, to, 240)) {
    const Vec2d at = path(crank).at;
    along.push_back(dot(line.direction, at - start));
    across.push_back(cross(line.direction, at - line.through));
  }
  return {{"along", along}, {"across", across}};
}

/// What a design reaches at the targets of its problem, or how it errs.
struct ReachedJson {
  const problems::Design& design;

  ordered_json operator()(const problems::FunctionProblem& problem) const {
    const auto wanted = problems::function_samples(problem);
    return {{"trace", trace_json(function_trace(problem, wanted, design))}};
  }
  ordered_json operator()(const problems::MotionProblem& problem) const {
    return reached_poses(design, problem.poses);
  }
  ordered_json operator()(const problems::StraightLineProblem& problem) const {
    ordered_json entry = reached_points(design);
    if (problem.goal) entry["deviation"] = deviation_json(design);
    return entry;
  }
  template <class Other>
  ordered_json operator()(const Other&) const {
    return reached_points(design);
  }
};

/// Where the target of a design came: p → [x, y] + scale·R(deg) p.
ordered_json placement_json(const problems::CurvePlacement& placement) {
  return {{"scale", placement.scale},
          {"deg", kDegreesInRadian * placement.turn},
          {"shift", point_json(placement.shift)}};
}

ordered_json transmission_limits(const problems::Problem& problem) {
  const auto& limits = std::visit(
      [](const auto& p) -> const auto& { return p.constraints.transmission_angle; }, problem);
  if (!limits) return nullptr;
  return {std::isfinite(limits->min) ? kDegreesInRadian * limits->min : 0,
          std::isfinite(limits->max) ? kDegreesInRadian * limits->max : 180};
}

}  // namespace

double round_to_digits(double x, int digits) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), x,
                                 std::chars_format::scientific, digits - 1)
                       .ptr;
  double rounded = x;
  std::from_chars(text.data(), end, rounded);
  return rounded;
}

ordered_json report_data(const problems::Problem& problem, const problems::Result& result) {
  const Fineness finely = fineness(result.designs.size());
  ordered_json designs = ordered_json::array();
  for (const problems::Design& design : result.designs) {
    ordered_json entry = motion_of(design, finely);
    entry.update(std::visit(ReachedJson{design}, problem));
    if (design.placement) entry["placement"] = placement_json(*design.placement);
    designs.push_back(entry);
  }
  return {{"target", std::visit(TargetJson{}, problem)},
          {"transmission_limits_deg", transmission_limits(problem)},
          {"designs", designs},
          {"loci", drawn_loci(result.loci)},
          {"families", drawn_families(result.families)}};
}

}  // namespace cognate::app
