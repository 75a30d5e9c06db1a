#include "app/kinds/guidance/kind.hpp"

#include <fmt/core.h>

#include "app/console/messages.hpp"
#include "app/console/table_text.hpp"
#include "app/documents/json_values.hpp"
#include "problems/basics/names.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;
using problems::MotionProblem;

constexpr Entry kGuidanceKeys[] = {
    {"target.poses", "[[x, y, angle_deg], ...], 2 to 10000 of them"},
    {"target.segments", "or: [[[x1, y1], [x2, y2]], ...], two points of the body in each pose"},
    {"target.method", "\"exact\" (default of 2 to 5 poses) or \"least-squares\" (3 and more)"},
    {"target.angle_weight",
     "least squares: length that counts as much as one radian (default: the rms way of the poses)"},
    {"mechanism.dyads", "which kinds may guide the body: \"RR\", \"PR\" (slider), \"RP\" (block)"},
    {"mechanism.fixed_pivots", "2 or 3 poses, or least squares: one or two of them [x, y]"},
    {"mechanism.moving_pivots",
     "2 or 3 poses, or least squares: one or two of them [u, v] in the body"},
    {"mechanism.fixed_pivot_line", "2 poses: [a, b, c], a x + b y = c, for the fixed pivots"},
    {"mechanism.crank", "2 poses, or least squares: length of the first dyad's link"},
    {"mechanism.rocker", "2 poses, or least squares: length of the second's"},
    {"bounds.moving_pivot_a",
     "least squares: [[umin, vmin], [umax, vmax]] in the body; moving_pivot_d: likewise"}};

constexpr QuantityColumn kGuidanceQuantities[] = {
    {"dyads", "pair of dyads"}, kObjectiveQuantities[0], kObjectiveQuantities[1]};

}  // namespace

std::span<const Entry> Kind<MotionProblem>::keys() {
  return kGuidanceKeys;
}

std::string Kind<MotionProblem>::describe(const MotionProblem& problem) {
  return titled(problem.title, fmt::format("motion generation, {} poses", problem.poses.size()));
}

ColumnChoice Kind<MotionProblem>::columns(const MotionProblem& /*problem*/) {
  return {.error_unit = "length", .places = true, .quantities = kGuidanceQuantities};
}

ordered_json Kind<MotionProblem>::target_json(const MotionProblem& problem) {
  ordered_json poses = ordered_json::array();
  for (const auto& [at, angle] : problem.poses) {
    poses.push_back(ordered_json::array({at.x, at.y, degrees(angle)}));
  }
  return {{"kind", "motion"}, {"poses", poses}};
}

ordered_json Kind<MotionProblem>::reached_json(const MotionProblem& problem,
                                               const problems::Design& design) {
  return reached_poses(design, problem.poses);
}

}  // namespace cognate::app
