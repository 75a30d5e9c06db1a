#include "app/report/design_drawing.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "analysis/mechanism/kinematics.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/convex_hull.hpp"
#include "app/drawing/design_motion.hpp"
#include "app/drawing/mechanism_poses.hpp"
#include "app/drawing/mechanism_shapes.hpp"
#include "app/report/drawn_number.hpp"
#include "app/report/guided_body.hpp"
#include "app/report/mechanism_json.hpp"
#include "app/report/report_data.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/guidance/design.hpp"
#include "problems/linkage/drive_span.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;
using problems::Design;
using problems::drive_span;
using synthesis::Pose;

ordered_json drawn_degrees(const std::vector<double>& angles) {
  ordered_json list = ordered_json::array();
  for (const double angle : angles) list.push_back(drawn(problems::degrees(angle)));
  return list;
}

ordered_json linkage_motion(const Design& design, int samples) {
  const DesignMotion motion = sample_motion(four_bar(design), design.crank_angles, samples);
  const bool even = motion.full_turn && std::ssize(motion.crank) == samples;
  return {{"motion",
           {{"full_turn", motion.full_turn},
            {"crank_deg", even ? ordered_json(nullptr) : drawn_degrees(motion.crank)},
            {"rocker_deg", drawn_degrees(motion.rocker)}}}};
}

ordered_json mechanism_motion(const Design& design, int samples) {
  const double unit = drive_unit(design.mechanism);
  ordered_json stations = ordered_json::array();
  for (const double at : design.crank_angles) stations.push_back(drawn(unit * at));
  ordered_json table = {{"drive", nullptr}, {"mechanism", nullptr}, {"stations", stations}};
  if (const auto span = drive_span(design.mechanism.mechanism, design.crank_angles)) {
    table["drive"] = drive_json(design.mechanism, *span);
    table["mechanism"] = mechanism_motion_json(design.mechanism, *span, samples);
  }
  return table;
}

ordered_json drawn_point(const Vec2d& point) {
  return ordered_json::array({drawn(point.x), drawn(point.y)});
}

ordered_json pose_json(const Pose& pose) {
  return ordered_json::array(
      {drawn(pose.at.x), drawn(pose.at.y), drawn(problems::degrees(pose.angle))});
}

/// Not rounded: errors are computed with it where a design is edited.
ordered_json axes_json(const Pose& axes) {
  return ordered_json::array({axes.at.x, axes.at.y, problems::degrees(axes.angle)});
}

/// Corners of the guided body in its own axes, from the shapes that the mechanism is drawn with,
/// the origin of the target's axes among them.
ordered_json outline_json(const Design& design, const GuidedBody& guided) {
  std::vector<Vec2d> corners = {guided.target_in_body.at};
  if (const auto span = drive_span(design.mechanism.mechanism, design.crank_angles)) {
    constexpr int kFew = 24;
    const auto poses = sample_poses(design.mechanism.mechanism, span->from, span->to, kFew);
    const auto shapes = mechanism_shapes(design.mechanism, poses);
    const auto& outline = shapes.bodies[static_cast<std::size_t>(guided.body)].outline;
    corners.insert(corners.end(), outline.begin(), outline.end());
  }
  ordered_json list = ordered_json::array();
  for (const Vec2d& corner : convex_hull(corners, 0)) list.push_back(drawn_point(corner));
  return list;
}

std::optional<Attached<double>> point_called(const Design& design, std::string_view name) {
  const auto& points = design.mechanism.points;
  const auto found = std::ranges::find(points, name, &problems::NamedPoint::name);
  return found == points.end() ? std::nullopt : std::optional(found->at);
}

/// The axes that the poses are of, in those of the body that is guided: as the design has them,
/// else as they were found from where the body stands.
Pose body_axes(const Design& design, const GuidedBody& guided, std::string_view origin_name) {
  const auto origin = point_called(design, origin_name.empty() ? "P" : origin_name);
  const auto angle = find_quantity(design.metrics.quantities, problems::kBodyAngleKey);
  if (!origin || origin->body != guided.body || !angle) return guided.target_in_body;
  return {origin->at, *angle};
}

}  // namespace

Fineness fineness(std::size_t designs) {
  constexpr int kLinkage = 24'000, kMechanism = 8'000;
  const int count = static_cast<int>(std::clamp<std::size_t>(designs, 1, 10'000));
  return {.linkage = std::clamp(kLinkage / count, 91, 361),
          .mechanism = std::clamp(kMechanism / count, 61, 361)};
}

ordered_json motion_of(const Design& design, const Fineness& fineness) {
  return design.mechanism.four_bar() ? linkage_motion(design, fineness.linkage)
                                     : mechanism_motion(design, fineness.mechanism);
}

ordered_json reached_points(const Design& design, std::string_view traced_name) {
  const auto traced = point_called(design, traced_name);
  MechanismMotion<0> motion(design.mechanism.mechanism);
  ordered_json list = ordered_json::array();
  for (const double at : design.crank_angles) {
    if (!traced || !motion.move_to(at)) {
      list.push_back(nullptr);
      continue;
    }
    const auto& body = motion.bodies()[static_cast<std::size_t>(traced->body)];
    const Vec2d point = point_motion(body, traced->at)[0];
    list.push_back(ordered_json::array({point.x, point.y}));
  }
  return {{"reached", list}};
}

ordered_json reached_poses(const Design& design, std::span<const Pose> targets,
                           std::string_view origin_name) {
  const auto origin = point_called(design, origin_name);
  auto guided = guided_body(design.mechanism, design.crank_angles, targets,
                            origin ? std::optional(origin->body) : std::nullopt);
  if (!guided) return {{"reached", ordered_json::array()}, {"guided", nullptr}};
  guided->target_in_body = body_axes(design, *guided, origin_name);
  ordered_json origins = ordered_json::array(), reached = origins;
  for (const auto& pose : guided->reached) {
    reached.push_back(pose ? pose_json(*pose) : ordered_json(nullptr));
    if (!pose) {
      origins.push_back(nullptr);
      continue;
    }
    const Vec2d origin = to_frame(*pose, guided->target_in_body.at);
    origins.push_back(ordered_json::array({origin.x, origin.y}));
  }
  return {{"reached", origins},
          {"guided",
           {{"body", guided->body},
            {"reached", reached},
            {"axes", axes_json(guided->target_in_body)},
            {"outline", outline_json(design, *guided)}}}};
}

}  // namespace cognate::app
