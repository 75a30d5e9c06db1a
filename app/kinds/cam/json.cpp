#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "analysis/cam/turn_extremes.hpp"
#include "analysis/numbers/constants.hpp"
#include "app/documents/json_values.hpp"
#include "app/documents/tolerance_json.hpp"
#include "app/kinds/cam/kind.hpp"
#include "problems/basics/names.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;
using problems::CamDesign;
using problems::CamProblem;
using problems::CamResult;
using problems::to_string;

/// `problem` with everything that it leaves free as `design` has it.
CamProblem settled(const CamProblem& problem, const CamDesign& design) {
  CamProblem found = problem;
  const auto& d = design.cam.system.follower.dimensions;
  const std::array values = {d.base_radius,     d.offset, d.roller_radius,
                             d.centre_distance, d.arm,    d.face_offset};
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (found.lengths[i].used) found.lengths[i].given = values[i];
  }
  found.motion = design.motion;
  found.free_motion.clear();
  if (design.second && !is_oscillating(problem.follower)) {
    found.second.breadth =
        design.cam.system.start + design.second->system.start + design.cam.programme.highest();
  }
  return found;
}

/// Follower, every length it has, the motion with what was found of it, and a preload that was
/// found.
ordered_json cam_mechanism_json(const CamProblem& problem, const CamDesign& design) {
  const ordered_json tables = problem_json(settled(problem, design));
  ordered_json mechanism = {{"type", "cam"}, {"follower", to_string(problem.follower)}};
  for (const char* key : {"side", "closure", "breadth", "arms_deg"}) {
    if (tables["follower"].contains(key)) mechanism[key] = tables["follower"][key];
  }
  mechanism.update(tables["mechanism"]);
  mechanism["motion"] = tables["motion"];
  const bool pressed = problem.second.closure == cam::Closure::force;
  if (problem.has_operation && pressed && !problem.preload) {
    mechanism["preload"] = design.operation.preload;
  }
  return mechanism;
}

/// 90° less the pressure angle, whose sign distinguishes the two sides of 90°; 0° or 180° where the
/// follower stands on the wrong side of the cam's centre.
ordered_json transmission_json(const cam::Cam& cam) {
  const auto pressure = turn_extremes(cam.programme, cam::MotionPart::whole, cam.system,
                                      cam::CamQuantity::pressure_angle);
  const auto angle = [](double pressure_angle) {
    return std::clamp(kRightAngle - pressure_angle, 0.0, 2 * kRightAngle);
  };
  const double least = angle(pressure ? pressure->greatest.value : 0);
  const double most = angle(pressure ? pressure->least.value : 0);
  return {{"min", degrees(least)},
          {"max", degrees(most)},
          {"acute_min", degrees(std::min(least, 2 * kRightAngle - most))}};
}

/// The cam angle of all rises over that of all returns; null where one of both is missing.
ordered_json time_ratio_json(const cam::MotionProgramme& programme) {
  double rises = 0, falls = 0;
  for (const auto& part : programme.stroke_parts()) {
    const double angle =
        programme.pieces()[static_cast<std::size_t>(part.piece)].span * (part.to - part.from);
    if (part.stroke == cam::Stroke::rise) rises += angle;
    if (part.stroke == cam::Stroke::fall) falls += angle;
  }
  return rises > 0 && falls > 0 ? ordered_json(rises / falls) : nullptr;
}

bool is_undercut(const CamDesign& design) {
  return std::ranges::any_of(design.metrics, [](const problems::Quantity& fact) {
    const auto* answer = std::get_if<bool>(&fact.value);
    return fact.name == "undercut" && answer != nullptr && *answer;
  });
}

ordered_json metrics_json(const CamProblem& problem, const CamDesign& design) {
  ordered_json table = {{"class", to_string(problem.follower)}};
  add_finite_quantities(table, design.metrics);
  table["transmission_angle_deg"] = transmission_json(design.cam);
  table["time_ratio"] = time_ratio_json(design.cam.programme);
  table["defects"] = ordered_json::array();
  if (is_undercut(design)) table["defects"].push_back("undercut");
  return table;
}

ordered_json proof_json(const problems::SizeProof& proof) {
  ordered_json positions = ordered_json::array();
  for (const auto& position : proof.positions) {
    positions.push_back({{"crank_deg", degrees(position.angle)},
                         {"limit", position.limit},
                         {"bound", position.bound}});
  }
  ordered_json table = {{"base_radius_least", proof.base_radius_least}, {"positions", positions}};
  if (!proof.within.empty()) table["within"] = proof.within;
  return table;
}

/// Infinite where velocity or acceleration jumps: null.
ordered_json factors_json(const cam::PeakFactors& factors) {
  const auto number = [](double value) {
    return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
  };
  return {{"velocity", number(factors.velocity)},
          {"acceleration", number(factors.acceleration)},
          {"jerk", number(factors.jerk)}};
}

ordered_json segments_json(const CamProblem& problem, const CamResult& result) {
  ordered_json rows = ordered_json::array();
  for (std::size_t i = 0; i < result.segments.size() && i < problem.motion.size(); ++i) {
    const auto& [factors, handbook] = result.segments[i];
    ordered_json row = {{"law", to_string(problem.motion[i].law)},
                        {"peak_factors", factors_json(factors)}};
    if (handbook) row["handbook"] = factors_json(*handbook);
    rows.push_back(row);
  }
  return rows;
}

ordered_json jumps_json(const CamResult& result) {
  constexpr std::array kOf = {"displacement", "velocity", "acceleration"};
  ordered_json rows = ordered_json::array();
  for (const auto& jump : result.jumps) {
    rows.push_back({{"at_deg", degrees(jump.angle)},
                    {"of", kOf.at(static_cast<std::size_t>(jump.order))},
                    {"before", jump.before},
                    {"after", jump.after}});
  }
  return rows;
}

}  // namespace

ordered_json Kind<CamProblem>::design_json(const CamProblem& problem, const CamResult& result,
                                           std::size_t index) {
  const CamDesign& design = result.designs[index];
  ordered_json table = {{"mechanism", cam_mechanism_json(problem, design)},
                        {"crank_deg", ordered_json::array()},
                        {"error", {{"sum_of_squares", 0.0}, {"rms", 0.0}, {"max", 0.0}}},
                        {"metrics", metrics_json(problem, design)},
                        {"constraints", ordered_json::array()}};
  for (const auto& check : design.constraints) table["constraints"].push_back(app::to_json(check));
  table["origin"] = design.origin;
  if (design.proof) table["proof"] = proof_json(*design.proof);
  if (design.tolerance) table["tolerance"] = tolerance_json(*design.tolerance);
  return table;
}

void Kind<CamProblem>::add_facts(ordered_json& table, const CamResult& result) {
  if (!result.quantities.empty()) add_finite_quantities(table["facts"], result.quantities);
}

void Kind<CamProblem>::add_findings(ordered_json& document, const CamProblem& problem,
                                    const CamResult& result) {
  document["segments"] = segments_json(problem, result);
  document["jumps"] = jumps_json(result);
  add_facts(document, result);
}

ExportOutcome Kind<CamProblem>::export_design(const ResultDesign& design,
                                              const ExportOptions& wanted,
                                              const std::string& stem) {
  return exported(result_cam(design),
                  [&](const ResultCam& cam) { return export_cam(cam, wanted, stem); });
}

}  // namespace cognate::app
