#include "app/report/cam_report_data.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "analysis/numbers/constants.hpp"
#include "app/drawing/cam_drawing.hpp"
#include "app/report/cam_json.hpp"
#include "app/report/drawn_number.hpp"
#include "app/report/quantity_json.hpp"
#include "problems/basics/names.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;
using problems::CamDesign;
using problems::CamProblem;
using problems::CamResult;

/// Segments and jumps that a table on a page holds at most.
constexpr std::size_t kCamRows = 400;

ordered_json optional_json(const std::optional<double>& value, double unit = 1) {
  return value ? drawn(unit * *value) : ordered_json(nullptr);
}

ordered_json limits_json(const problems::CamConstraints& limits) {
  return {
      {"pressure_deg", optional_json(limits.pressure_angle_max, kDegreesInRadian)},
      {"rise_deg", optional_json(limits.pressure_angle_max_rise, kDegreesInRadian)},
      {"return_deg", optional_json(limits.pressure_angle_max_return, kDegreesInRadian)},
      {"rise_working_deg", optional_json(limits.pressure_angle_max_rise_working, kDegreesInRadian)},
      {"return_working_deg",
       optional_json(limits.pressure_angle_max_return_working, kDegreesInRadian)},
      {"convex_radius", optional_json(limits.curvature_radius_min)},
      {"concave_radius", optional_json(limits.concave_radius_min)},
      {"force", optional_json(limits.contact_force_max)},
      {"torque", optional_json(limits.torque_max)},
      {"stress", optional_json(limits.contact_stress_max)}};
}

ordered_json factors_json(const std::optional<cam::PeakFactors>& factors) {
  if (!factors) return nullptr;
  return {{"velocity", drawn(factors->velocity)},
          {"acceleration", drawn(factors->acceleration)},
          {"jerk", drawn(factors->jerk)}};
}

/// The segments of `design`; `quantities` are those of their laws, or empty.
ordered_json segments_json(const CamDesign& design,
                           const std::vector<problems::SegmentQuantities>& quantities) {
  const bool swings = is_oscillating(design.cam.system.follower.type);
  ordered_json list = ordered_json::array();
  double from = 0;
  for (std::size_t i = 0; i < std::min(kCamRows, design.motion.size()); ++i) {
    const cam::MotionSegment& segment = design.motion[i];
    list.push_back({{"law", problems::to_string(segment.law)},
                    {"from_deg", drawn(kDegreesInRadian * from)},
                    {"over_deg", drawn(kDegreesInRadian * segment.over)},
                    {"rise", drawn((swings ? kDegreesInRadian : 1) * segment.rise)}});
    from += segment.over;
    if (i >= quantities.size()) continue;
    list.back()["factors"] = factors_json(quantities[i].factors);
    list.back()["handbook"] = factors_json(quantities[i].handbook);
  }
  return list;
}

const char* name_of(cam::Stroke stroke) {
  switch (stroke) {
    case cam::Stroke::rise:
      return "rise";
    case cam::Stroke::fall:
      return "return";
    default:
      return "dwell";
  }
}

ordered_json strokes_json(const cam::MotionProgramme& programme) {
  const auto strokes = cam_strokes(programme);
  ordered_json list = ordered_json::array();
  if (strokes.size() > kCamRows) return list;
  for (const CamStroke& stroke : strokes) {
    list.push_back({{"from_deg", drawn(kDegreesInRadian * stroke.from)},
                    {"to_deg", drawn(kDegreesInRadian * stroke.to)},
                    {"stroke", name_of(stroke.stroke)}});
  }
  return list;
}

ordered_json proof_json(const std::optional<problems::SizeProof>& proof) {
  if (!proof) return nullptr;
  ordered_json positions = ordered_json::array();
  for (const auto& position : proof->positions) {
    positions.push_back({{"deg", drawn(kDegreesInRadian * position.angle)},
                         {"limit", position.limit},
                         {"bound", drawn(position.bound)}});
  }
  return {{"base_radius", drawn(proof->base_radius_least)},
          {"positions", positions},
          {"within", proof->within}};
}

ordered_json jumps_json(const CamResult& result) {
  ordered_json list = ordered_json::array();
  for (std::size_t i = 0; i < std::min(kCamRows, result.jumps.size()); ++i) {
    const cam::Jump& jump = result.jumps[i];
    list.push_back({{"deg", drawn(kDegreesInRadian * jump.angle)},
                    {"order", jump.order},
                    {"before", drawn(jump.before)},
                    {"after", drawn(jump.after)}});
  }
  return list;
}

ordered_json design_json(const CamProblem& problem, const CamResult& result, std::size_t index) {
  const CamDesign& design = result.designs[index];
  const CamFineness fineness = cam_fineness(result.designs.size());
  ordered_json entry = cam_json(design.cam, problem, design.operation, fineness);
  const auto walls = parallel_curves(problem, design.cam, CamCurveKind::profile);
  if (walls.size() > 1) entry["outer"] = curve_json(design.cam, walls[1].distance, fineness);
  if (design.second) {
    // Of a translating follower the other cam's roller is on the far side of the shaft.
    entry["second"] = cam_json(*design.second, problem, design.operation, fineness);
    entry["second"]["turn_deg"] = is_oscillating(problem.follower) ? 0 : 180;
  }
  entry["strokes"] = strokes_json(design.cam.programme);
  // The laws' quantities are those of the best design, and of the others where no law is free.
  const bool known = index == 0 || problem.free_motion.empty();
  entry["segments"] =
      segments_json(design, known ? result.segments : std::vector<problems::SegmentQuantities>{});
  entry["segment_count"] = design.motion.size();
  const double speed = design.operation.speed;
  entry["speed"] = speed > 0 ? drawn(speed) : ordered_json(nullptr);
  entry["preload"] =
      problem.has_operation ? drawn(design.operation.preload) : ordered_json(nullptr);
  entry["metrics"] = quantities_json(design.metrics);
  entry["constraints"] = constraints_json(design.constraints);
  entry["proof"] = proof_json(design.proof);
  entry["origin"] = design.origin;
  return entry;
}

}  // namespace

ordered_json cam_report_data(const CamProblem& problem, const CamResult& result) {
  ordered_json designs = ordered_json::array();
  for (std::size_t i = 0; i < result.designs.size(); ++i) {
    designs.push_back(design_json(problem, result, i));
  }
  return {{"follower", problems::to_string(problem.follower)},
          {"flat", is_flat(problem.follower)},
          {"oscillating", is_oscillating(problem.follower)},
          {"knife", is_knife(problem.follower)},
          {"closure", problems::to_string(problem.second.closure)},
          {"clockwise", problem.clockwise},
          {"limits", limits_json(problem.constraints)},
          {"jumps", jumps_json(result)},
          {"jump_count", result.jumps.size()},
          {"designs", designs}};
}

}  // namespace cognate::app
