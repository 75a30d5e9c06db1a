#include <array>
#include <cmath>
#include <utility>

#include "analysis/numbers/constants.hpp"
#include "app/documents/problem_tables.hpp"
#include "app/kinds/cam/kind.hpp"
#include "problems/basics/names.hpp"

namespace cognate::app {
namespace {

using cam::MotionLaw;
using nlohmann::ordered_json;
using problems::CamProblem;
using problems::MotionParameter;
using problems::to_string;

/// An angle or a share of the segment `index`: the range in which it is free, else its value.
class FreeValues {
 public:
  explicit FreeValues(const CamProblem& problem) : free_(problem.free_motion) {}

  /// Segments must be requested in order.
  const problems::Range* find(std::size_t segment, MotionParameter parameter) {
    while (next_ < free_.size() && free_[next_].segment < segment) ++next_;
    for (std::size_t i = next_; i < free_.size() && free_[i].segment == segment; ++i) {
      if (free_[i].parameter == parameter) return &free_[i].range;
    }
    return nullptr;
  }

 private:
  const std::vector<problems::FreeMotionParameter>& free_;
  std::size_t next_ = 0;
};

/// The angle, in degrees, of which the reader makes the share `at` of a segment.
double place_deg(double at, double over) {
  const double nearest = problems::degrees(at * over);
  double low = nearest, high = nearest;
  for (int i = 0; i < 8; ++i) {  // rounding is a few units in the last place
    if (low * kDegree / over == at) return low;
    if (high * kDegree / over == at) return high;
    low = std::nextafter(low, 0.0);
    high = std::nextafter(high, 360.0);
  }
  return nearest;
}

/// A displacement in the file's unit.
double shown(double displacement, bool oscillating) {
  return oscillating ? problems::degrees(displacement) : displacement;
}

ordered_json conditions(const cam::MotionSegment& segment, bool oscillating) {
  const std::array<const char*, 4> keys{oscillating ? "displacement_deg" : "displacement",
                                        "velocity", "acceleration", "jerk"};
  ordered_json rows = ordered_json::array();
  for (const cam::MotionCondition& condition : segment.conditions) {
    const bool angle = oscillating && condition.order == 0;
    rows.push_back(
        {{"at_deg", place_deg(condition.at, segment.over)},
         {keys.at(static_cast<std::size_t>(condition.order)), shown(condition.value, angle)}});
  }
  return rows;
}

void add_spline(const cam::MotionSegment& segment, bool oscillating, ordered_json& table) {
  table["points"] = ordered_json::array();
  for (const cam::SplinePoint& point : segment.points) {
    table["points"].push_back(ordered_json::array(
        {place_deg(point.at, segment.over), shown(point.displacement, oscillating)}));
  }
  table["degree"] = segment.degree;
  const cam::SplineEnds& ends = segment.ends;
  if (ends.periodic) {
    table["periodic"] = true;
    return;
  }
  table["velocity"] = {ends.velocity_begin, ends.velocity_end};
  if (segment.degree == 5) {
    table["acceleration"] = {ends.acceleration_begin, ends.acceleration_end};
  }
}

ordered_json segment_table(const cam::MotionSegment& segment, std::size_t index, bool oscillating,
                           FreeValues& free) {
  ordered_json table = {{"law", to_string(segment.law)}};
  const problems::Range* over = free.find(index, MotionParameter::over);
  table["over_deg"] = over ? to_json_deg(*over) : ordered_json(problems::degrees(segment.over));
  if (segment.law != MotionLaw::dwell) {
    table[oscillating ? "rise_deg" : "rise"] = shown(segment.rise, oscillating);
  }
  if (segment.law == MotionLaw::universal) {
    const auto share = [&](MotionParameter parameter, double value) {
      const problems::Range* range = free.find(index, parameter);
      table[std::string(to_string(parameter))] = range ? to_json(*range) : ordered_json(value);
    };
    share(MotionParameter::sine, segment.shape.sine);
    share(MotionParameter::constant, segment.shape.constant);
    share(MotionParameter::cosine, segment.shape.cosine);
  }
  if (segment.law == MotionLaw::polynomial) {
    table["conditions"] = conditions(segment, oscillating);
  }
  if (segment.law == MotionLaw::spline) add_spline(segment, oscillating, table);
  return table;
}

ordered_json motion(const CamProblem& problem) {
  ordered_json rows = ordered_json::array();
  FreeValues free(problem);
  const bool oscillating = is_oscillating(problem.follower);
  for (std::size_t i = 0; i < problem.motion.size(); ++i) {
    rows.push_back(segment_table(problem.motion[i], i, oscillating, free));
  }
  return rows;
}

ordered_json follower(const CamProblem& problem) {
  const bool oscillating = is_oscillating(problem.follower);
  ordered_json table = {{"type", to_string(problem.follower)}};
  if (oscillating) table["side"] = to_string(problem.side);
  table["closure"] = to_string(problem.second.closure);
  set(table, "breadth", problem.second.breadth);
  set_deg(table, "arms_deg", problem.second.arms_angle);
  if (!problem.has_operation) return table;
  if (problem.operation.inertia > 0) {
    table[oscillating ? "inertia" : "mass"] = problem.operation.inertia;
  }
  table["spring_rate"] = problem.operation.spring_rate;
  set(table, "preload", problem.preload);
  table["load"] = problem.operation.load;
  return table;
}

ordered_json constraints(const CamProblem& problem) {
  const problems::CamConstraints& given = problem.constraints;
  ordered_json table = ordered_json::object();
  set_deg(table, "pressure_angle_deg_max", given.pressure_angle_max);
  set_deg(table, "pressure_angle_deg_max_rise", given.pressure_angle_max_rise);
  set_deg(table, "pressure_angle_deg_max_return", given.pressure_angle_max_return);
  set_deg(table, "pressure_angle_deg_max_rise_working", given.pressure_angle_max_rise_working);
  set_deg(table, "pressure_angle_deg_max_return_working", given.pressure_angle_max_return_working);
  set(table, "curvature_radius_min", given.curvature_radius_min);
  table["no_undercut"] = given.curvature_radius_min.has_value();
  set(table, "concave_radius_min", given.concave_radius_min);
  set(table, "face_width_max", given.face_width_max);
  set(table, "profile_radius_min", given.profile_radius_min);
  set(table, "profile_radius_max", given.profile_radius_max);
  set(table, "contact_force_max", given.contact_force_max);
  set(table, "torque_max", given.torque_max);
  set(table, "contact_stress_max", given.contact_stress_max);
  const bool may_separate = problem.has_operation && problem.second.closure == cam::Closure::force;
  if (may_separate) table["no_separation"] = given.no_separation;
  return table;
}

/// Whether bounds say more than that lengths are positive; that a face's offset has any says that
/// it is free.
bool says_anything(problems::CamDimension dimension, const problems::CamLength& length) {
  const auto& [min, max] = length.bounds;
  const bool is_face_offset = dimension == problems::CamDimension::face_offset;
  if (is_face_offset && !length.given) return true;
  const bool is_signed = is_face_offset || dimension == problems::CamDimension::offset;
  return std::isfinite(max) || (is_signed ? std::isfinite(min) : min > 0);
}

void add_lengths(const CamProblem& problem, ordered_json& tables) {
  ordered_json mechanism = ordered_json::object();
  ordered_json bounds = ordered_json::object();
  for (const auto& dimension : problems::names<problems::CamDimension>()) {
    const problems::CamLength& length = problem.length(dimension.value);
    const std::string key(dimension.name);
    if (length.given) mechanism[key] = *length.given;
    if (length.used && says_anything(dimension.value, length)) {
      bounds[key] = to_json(length.bounds);
    }
  }
  mechanism["rotation"] = problem.clockwise ? "cw" : "ccw";
  tables["mechanism"] = std::move(mechanism);
  tables["bounds"] = std::move(bounds);
}

void add_contact(const CamProblem& problem, ordered_json& tables) {
  if (problem.operation.speed > 0) tables["drive"] = {{"speed", problem.operation.speed}};
  if (!problem.materials) return;
  tables["contact"] = {{"width", problem.operation.width},
                       {"elasticity", problem.materials->elasticity},
                       {"poisson", problem.materials->poisson}};
}

}  // namespace

ordered_json Kind<CamProblem>::to_json(const CamProblem& problem) {
  ordered_json tables = document("cam", problem.title);
  tables["follower"] = follower(problem);
  tables["motion"] = motion(problem);
  add_lengths(problem, tables);
  tables["target"] = {{"objective", to_string(problem.objective)}};
  tables["constraints"] = constraints(problem);
  add_contact(problem, tables);
  tables["solve"] = solve_table(problem.solve);
  return tables;
}

}  // namespace cognate::app
