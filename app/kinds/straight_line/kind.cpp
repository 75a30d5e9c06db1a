#include "app/kinds/straight_line/kind.hpp"

#include <fmt/core.h>

#include <cmath>

#include "analysis/coupler_curve/straightness.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/zeros.hpp"
#include "app/console/messages.hpp"
#include "app/console/table_text.hpp"
#include "problems/basics/names.hpp"
#include "problems/straight_line/keys.hpp"
#include "problems/straight_line/normalised.hpp"
#include "problems/straight_line/placing.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;
using problems::StraightLineProblem;

constexpr Entry kPlace[] = {
    {"target.constant_velocity", "true: constraints.speed_variation_max = 0.1 unless given"},
    {"target.method", "\"exact\": by the theory of contact; by default linkages are searched"},
    {"target.contact", "exact: 3, 4 or 5 coinciding points of path and line (default 5)"},
    {"mechanism.type", "\"four-bar\" (default) or \"slider-crank\""},
    {"mechanism.crank", "its length; coupler, rocker, frame: likewise; contact 5 may find one"},
    {"mechanism.crank_deg", "the position; contact 5 may find it"},
    {"mechanism.cranks", "\"any\" (default), \"parallel\" or \"symmetric\""},
    {"mechanism.sides", "of parallel cranks: \"same\" or \"opposite\""},
    {"mechanism.coupler_angle_deg", "of parallel cranks: direction of the coupler"},
    {"mechanism.pivot_a", "[x, y] of the crank's pivot, pivot_d: of the rocker's"},
    {"mechanism.fixed_pivots", "or: both"},
    {"mechanism.frame_angle_deg", "direction from A to D"},
    {"mechanism.assembly", "\"open\" or \"crossed\"; both by default"},
    {"mechanism.pivot", "slider-crank: [x, y] of the crank's pivot"},
    {"mechanism.offset", "slider-crank: of the slide line (exact: default 0)"},
    {"mechanism.direction_deg", "slider-crank: of the slide line (default 0)"}};

constexpr Entry kRatio[] = {{"constraints.link_ratio_max", "search: 10 by default"}};

constexpr auto kStraightLine =
    entries_of(problems::reading::kGoalKeys, kPlace, problems::reading::kSegmentKeys, kRatio);

constexpr QuantityColumn kStraightLineQuantities[] = {
    {"contact_points", "points of contact"},
    {"straight_length_at_0_001", "straight to 0.1 % [length]"},
    {"straight_length_at_0_01", "to 1 % [length]"}};
constexpr QuantityColumn kSearchedLineQuantities[] = {{"straight_length", "straight [length]"},
                                                      {"deviation_relative", "deviation/length"},
                                                      {"size_over_length", "size/length"}};

/// The distances of the curve from the line that was sought, and the places along it: finer than
/// the positions drawn resolve. Null without such a stretch.
ordered_json deviation_json(const StraightLineProblem& problem, const problems::Design& design) {
  const auto& quantities = design.metrics.quantities;
  const auto from = find_quantity(quantities, problems::kSegmentFromKey),
             to = find_quantity(quantities, problems::kSegmentToKey);
  const auto& points = design.mechanism.points;
  if (!from || !to || points.empty()) return nullptr;
  const Path path = path_of(design.mechanism.mechanism, points.back().at);
  const Line line = measured(problem, path, *from, *to).line;
  const Vec2d start = path(*from).at;
  std::vector<double> along, across;
  for (const double crank : crowded(*from, *to, 240)) {
    const Vec2d at = path(crank).at;
    along.push_back(dot(line.direction, at - start));
    across.push_back(cross(line.direction, at - line.through));
  }
  return {{"along", along}, {"across", across}};
}

}  // namespace

std::span<const Entry> Kind<StraightLineProblem>::keys() {
  return kStraightLine;
}

std::string Kind<StraightLineProblem>::describe(const StraightLineProblem& problem) {
  return titled(problem.title, "approximate straight line");
}

ColumnChoice Kind<StraightLineProblem>::columns(const StraightLineProblem& problem) {
  if (problem.goal)
    return {.coupler_point = true, .places = true, .quantities = kSearchedLineQuantities};
  return {.coupler_point = true, .places = true, .quantities = kStraightLineQuantities};
}

ordered_json Kind<StraightLineProblem>::target_json(const StraightLineProblem& problem) {
  ordered_json target{{"kind", "straight-line"}};
  if (!problem.goal || !problem.goal->ends) return target;
  for (const Vec2d& end : *problem.goal->ends) target["ends"].push_back({end.x, end.y});
  return target;
}

ordered_json Kind<StraightLineProblem>::reached_json(const StraightLineProblem& problem,
                                                     const problems::Design& design) {
  ordered_json entry = reached_points(design);
  if (problem.goal) entry["deviation"] = deviation_json(problem, design);
  return entry;
}

}  // namespace cognate::app
