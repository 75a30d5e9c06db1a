#include "app/kinds/chain_motion/kind.hpp"

#include <fmt/core.h>

#include "app/console/messages.hpp"
#include "app/documents/json_values.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;
using problems::ChainMotionProblem;

constexpr Entry kChainMotionKeys[] = {
    {"target.poses", "[[x, y, angle_deg], ...], 3 to 10000 of them"},
    {"target.segments", "or: [[[x1, y1], [x2, y2]], ...], two points of the body in each pose"},
    {"target.closed",
     "whether the first pose follows the last (default: the last repeats the first)"},
    {"target.angle_weight",
     "length that counts as much as one radian (default: the rms way of the poses)"},
    {"target.timing", "\"free\" (default), or \"prescribed\" by crank_deg"},
    {"target.crank_deg", "the crank's angle at each pose, of which differences count"},
    {"target.point", "chain: the body's origin, a [[point]] on its link (default: the last)"},
    {"mechanism.type",
     "a topology of the list of paths, or \"chain\"; parts and bounds as of path-generation "
     "(chains); without a type four-bars and other pairs of dyads guide the body"},
    {"constraints.transmission_angle_deg", "[min, max] of every dyad"},
    {"constraints.over",
     "where that holds: \"turn\" (default) of the crank, or \"range\", from the first to the last "
     "pose"},
    {"constraints.rms_error_max", "the most root mean square of the errors of place and angle"},
    {"solve.objectives",
     "[\"error\", and one of \"transmission_angle\", \"size\", \"links\"]: a Pareto front"}};

constexpr QuantityColumn kChainMotionQuantities[] = {
    {"link_count", "links"}, {"longest_link", "longest link [length]"}, {"topology", "topology"}};

}  // namespace

std::span<const Entry> Kind<ChainMotionProblem>::keys() {
  return kChainMotionKeys;
}

std::string Kind<ChainMotionProblem>::describe(const ChainMotionProblem& problem) {
  return titled(problem.title,
                fmt::format("motion generation, {}, {} poses{}, {} timing", problem.mechanism,
                            problem.poses.size(), problem.closed ? " of a closed motion" : "",
                            problem.crank_angles.empty() ? "free" : "prescribed"));
}

ColumnChoice Kind<ChainMotionProblem>::columns(const ChainMotionProblem& /*problem*/) {
  return {.error_unit = "length", .quantities = kChainMotionQuantities};
}

ordered_json Kind<ChainMotionProblem>::target_json(const ChainMotionProblem& problem) {
  ordered_json poses = ordered_json::array();
  for (const auto& [at, angle] : problem.poses) {
    poses.push_back(ordered_json::array({at.x, at.y, degrees(angle)}));
  }
  return {{"kind", "motion"}, {"poses", poses}};
}

ordered_json Kind<ChainMotionProblem>::reached_json(const ChainMotionProblem& problem,
                                                    const problems::Design& design) {
  return reached_poses(design, problem.poses, problems::origin_name(problem));
}

}  // namespace cognate::app
