#include "problems/evaluation/column_plan.hpp"

#include <fmt/core.h>

#include <array>
#include <string_view>

#include "analysis/mechanism/joints.hpp"
#include "problems/evaluation/instant_geometry.hpp"
#include "problems/mechanism/joint_names.hpp"

namespace cognate::problems {
namespace {

struct Derivative {
  const char* quantity;
  const char* suffix;
  const char* unit;
};

constexpr Derivative kAngle{"position", "_deg", "deg"};
constexpr Derivative kAngularVelocity{"velocity", "_omega_rad_s", "rad/s"};
constexpr Derivative kAngularAcceleration{"acceleration", "_alpha_rad_s2", "rad/s2"};
constexpr Derivative kDisplacement{"position", "_s", "length"};
constexpr Derivative kSlideVelocity{"velocity", "_v_per_s", "length/s"};
constexpr Derivative kSlideAcceleration{"acceleration", "_a_per_s2", "length/s2"};

/// Appends columns to a table, and returns their places.
class Planner {
 public:
  Planner(const AnalysisProblem& problem, ColumnPlan& plan) : problem_(problem), plan_(plan) {}

  ColumnIndex add(const std::string& name, const char* quantity, const std::string& of,
                  const char* unit) {
    plan_.columns.push_back({name, quantity, of, unit, {}});
    return static_cast<ColumnIndex>(plan_.columns.size()) - 1;
  }

  void add_drive() {
    const bool slides = driven_by_length(problem_.mechanism.mechanism.drive);
    add(drive_column_name(problem_.mechanism.mechanism), "drive", problem_.mechanism.bodies[1],
        slides ? "length" : "deg");
  }

  void add_bodies() {
    const auto turns = turning_bodies(problem_.mechanism.mechanism);
    constexpr int kFirstDriven = 2;
    for (int body = kFirstDriven; body < static_cast<int>(turns.size()); ++body) {
      if (!turns[static_cast<std::size_t>(body)]) continue;
      plan_.bodies.push_back({body, coordinate(problem_.mechanism.bodies[std::size_t(body)], kAngle,
                                               kAngularVelocity, kAngularAcceleration)});
    }
  }

  void add_slides() {
    for (const auto& pair : sliding_pairs(problem_.mechanism.mechanism)) {
      plan_.slides.push_back({pair, coordinate(problem_.mechanism.bodies[std::size_t(pair.slider)],
                                               kDisplacement, kSlideVelocity, kSlideAcceleration)});
    }
  }

  void add_points() {
    const auto& points = problem_.mechanism.points;
    const auto& chosen = problem_.output.points;
    for (const int index : chosen) add_point(points[static_cast<std::size_t>(index)]);
    if (!chosen.empty()) return;
    for (const auto& point : points) {
      if (point.at.body != 0) add_point(point);
    }
  }

  void add_transmissions() {
    const auto& dyads = problem_.mechanism.mechanism.dyads;
    const auto names = dyad_names(problem_.mechanism);
    const auto is_rrr = [&](std::size_t i) {
      return std::holds_alternative<Rrr<double>>(dyads[i]);
    };
    std::array<std::size_t, 2> alike{};
    for (std::size_t i = 0; i < dyads.size(); ++i) alike[is_rrr(i)] += !is_of_group(dyads[i]);
    for (std::size_t i = 0; i < dyads.size(); ++i) {
      if (is_of_group(dyads[i])) continue;
      const std::string which = alike[is_rrr(i)] > 1 ? names[i] + "_" : "";
      const char* what = is_rrr(i) ? "transmission_deg" : "pressure_deg";
      plan_.transmissions.push_back(
          {static_cast<int>(i), !is_rrr(i), add(which + what, "transmission", names[i], "deg")});
    }
  }

  void add_instant_geometry() {
    for (const int body : problem_.output.instant_geometry) {
      const auto& name = problem_.mechanism.bodies[static_cast<std::size_t>(body)];
      plan_.instants.push_back({body, static_cast<ColumnIndex>(plan_.columns.size())});
      for (const char* suffix : instant_geometry_columns()) {
        const bool angle = std::string_view(suffix).ends_with("_deg");
        add(fmt::format("{}_{}", name, suffix), "instant-geometry", name, angle ? "deg" : "length");
      }
    }
  }

  void add_reactions() {
    const JointList list = joints(problem_.mechanism.mechanism);
    const auto names = joint_names(problem_.mechanism);
    for (std::size_t i = 0; i < list.joints.size(); ++i) {
      plan_.joints.push_back(joint_columns(static_cast<int>(i), list.joints[i], names[i]));
    }
    plan_.shaking = add_vector("shaking", "_N", "reactions", "frame", "N", "_F");
    add("shaking_moment_N_m", "reactions", "frame", "N m");
  }

  void add_drive_force() {
    const bool slides = driven_by_length(problem_.mechanism.mechanism.drive);
    plan_.drive_force = add(slides ? "drive_force_N" : "torque_N_m", "torque",
                            problem_.mechanism.bodies[1], slides ? "N" : "N m");
  }

 private:
  JointColumns joint_columns(int index, const Joint& joint, const std::string& name) {
    const auto& second = problem_.mechanism.bodies[static_cast<std::size_t>(joint.second)];
    if (joint.type == JointType::revolute) {
      const std::string at = fmt::format("{}_on_{}", name, second);
      return {index, false, add_vector(at, "_N", "reactions", name, "N", "_F")};
    }
    const auto& first = problem_.mechanism.bodies[static_cast<std::size_t>(joint.first)];
    const std::string pair = fmt::format("{}_on_{}", first, second);
    const ColumnIndex normal = add(pair + "_N", "reactions", name, "N");
    add(pair + "_moment_N_m", "reactions", name, "N m");
    return {index, true, normal};
  }

  CoordinateColumns coordinate(const std::string& name, const Derivative& position,
                               const Derivative& velocity, const Derivative& acceleration) {
    const auto& wanted = problem_.output;
    const auto one = [&](const Derivative& which) {
      return add(name + which.suffix, which.quantity, name, which.unit);
    };
    CoordinateColumns columns;
    if (wanted.position) columns.position = one(position);
    if (wanted.velocity) columns.velocity = one(velocity);
    if (wanted.acceleration) columns.acceleration = one(acceleration);
    return columns;
  }

  ColumnIndex add_vector(const std::string& name, const char* suffix, const char* quantity,
                         const std::string& of, const char* unit, const char* prefix) {
    const ColumnIndex first = add(name + prefix + "x" + suffix, quantity, of, unit);
    add(name + prefix + "y" + suffix, quantity, of, unit);
    return first;
  }

  void add_point(const NamedPoint& point) {
    const auto& wanted = problem_.output;
    const auto vector = [&](const char* suffix, const char* quantity, const char* unit,
                            const char* prefix) {
      return add_vector(point.name, suffix, quantity, point.name, unit, prefix);
    };
    PointColumns columns{.at = point.at};
    if (wanted.position) columns.coordinates.position = vector("", "position", "length", "_");
    if (wanted.velocity) {
      columns.coordinates.velocity = vector("_per_s", "velocity", "length/s", "_v");
    }
    if (wanted.acceleration) {
      columns.coordinates.acceleration = vector("_per_s2", "acceleration", "length/s2", "_a");
    }
    if (wanted.curvature) {
      columns.curvature = add(point.name + "_curvature", "curvature", point.name, "1/length");
    }
    plan_.points.push_back(columns);
  }

  const AnalysisProblem& problem_;
  ColumnPlan& plan_;
};

}  // namespace

ColumnPlan plan_columns(const AnalysisProblem& problem) {
  const auto& wanted = problem.output;
  ColumnPlan plan;
  Planner planner(problem, plan);
  planner.add_drive();
  planner.add_bodies();
  planner.add_slides();
  planner.add_points();
  if (wanted.transmission) planner.add_transmissions();
  planner.add_instant_geometry();
  if (wanted.torque) planner.add_drive_force();
  if (wanted.reactions) planner.add_reactions();
  return plan;
}

int needed_order(const AnalysisOutput& output) {
  if (!output.instant_geometry.empty()) return 3;
  if (output.acceleration || output.curvature || output.reactions || output.torque) return 2;
  return output.velocity ? 1 : 0;
}

std::string drive_column_name(const Mechanism<double>& mechanism) {
  return driven_by_length(mechanism.drive) ? "slide" : "crank_deg";
}

}  // namespace cognate::problems
