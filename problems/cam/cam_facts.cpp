#include "problems/cam/cam_facts.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/cam/profile.hpp"
#include "problems/cam/cam_extremes.hpp"
#include "problems/degrees.hpp"
#include "problems/verify.hpp"

namespace cognate::problems {
namespace {

using cam::Stretch;

class Facts {
 public:
  Facts(const CamProblem& problem, const CamDesign& design)
      : problem_(problem), design_(design), cam_(design.cam) {}

  std::vector<Fact> all() && {
    add_motion();
    add_pressure();
    add_shape();
    add_forces();
    return std::move(facts_);
  }

 private:
  void add(const char* name, double value) { facts_.push_back({name, value}); }
  void add_at(const std::string& name, const FoundAt& found, double unit = 1) {
    facts_.push_back({name, unit * found.value});
    facts_.push_back({name + "_at_deg", degrees(found.angle)});
  }

  /// The follower's greatest displacement, and at a given speed its velocity and acceleration.
  void add_motion() {
    const bool swings = is_oscillating(problem_.follower);
    const double highest = cam_.programme.highest();
    add(swings ? "swing_deg" : "stroke", swings ? degrees(highest) : highest);
    const double speed = problem_.operation.speed;
    if (!(speed > 0)) return;
    const auto peak = [&](double cam::FollowerMotion<double>::*derivative, double unit) {
      const auto all = turn_extremes(
          cam_.programme, Stretch::whole,
          [derivative](const cam::FollowerMotion<double>& m) { return m.*derivative; });
      const bool down = -all->least.value > all->greatest.value;
      const auto& far = down ? all->least : all->greatest;
      return FoundAt{unit * std::abs(far.value), far.place.angle};
    };
    using Motion = cam::FollowerMotion<double>;
    add_at("follower_velocity_max", peak(&Motion::velocity, speed));
    add_at("follower_acceleration_max", peak(&Motion::acceleration, speed * speed));
    add_at("follower_jerk_max", peak(&Motion::jerk, speed * speed * speed));
  }

  void add_pressure() {
    if (problem_.follower == cam::FollowerType::translating_flat) {
      add("pressure_angle_deg_max", 0);
      return;
    }
    add_at("pressure_angle_deg_max", greatest_pressure_angle(cam_), degrees(1));
    const auto rise = pressure_angle_of(cam_, Stretch::rises);
    const auto fall = pressure_angle_of(cam_, Stretch::falls);
    if (rise) add_at("pressure_angle_deg_max_rise", *rise, degrees(1));
    if (fall) add_at("pressure_angle_deg_max_return", *fall, degrees(1));
  }

  void add_shape() {
    const auto convex = least_convex_radius(cam_), concave = least_concave_radius(cam_);
    if (convex) add_at("curvature_radius_min", *convex);
    if (concave) add_at("concave_radius_min", *concave);
    facts_.push_back({"undercut", (convex && convex->value < 0) || profile_crosses_itself()});
    add("profile_radius_min", least_profile_radius(cam_).value);
    add("profile_radius_max", greatest_profile_radius(cam_).value);
    if (is_flat(problem_.follower)) add("face_width", face_width(cam_));
  }

  bool profile_crosses_itself() const {
    constexpr std::size_t kMost = 20000;
    const auto& d = cam_.system.follower.dimensions;
    const double size = d.base_radius + cam_.programme.highest();
    return cam::crosses_itself(
        cam::polygon({cam_.system, cam_.programme, -d.roller_radius}, 1e-5 * size, kMost));
  }

  void add_forces() {
    const bool rolls = cam_.system.follower.dimensions.roller_radius > 0;
    const double speed = problem_.operation.speed;
    if (rolls) {
      const bool known = speed > 0;
      add_at(known ? "roller_speed_max" : "roller_speed_ratio_max", greatest_roller_speed(cam_),
             known ? speed : 1);
    }
    if (!problem_.has_operation) return;
    if (problem_.second.closure == cam::Closure::force) {
      add("preload", design_.operation.preload);
      add("preload_min", least_preload(cam_));
    }
    add_at("demand_min", least_demand(cam_));
    add_at("contact_force_max", greatest_force(cam_));
    add_at("torque_max", greatest_torque(cam_));
    if (problem_.has_contact) add_at("contact_stress_max", greatest_stress(cam_));
  }

  const CamProblem& problem_;
  const CamDesign& design_;
  const cam::Cam& cam_;
  std::vector<Fact> facts_;
};

class Checks {
 public:
  explicit Checks(const CamProblem& problem, const CamDesign& design)
      : problem_(problem), design_(design), cam_(design.cam) {}

  std::vector<ConstraintCheck> all() && {
    add_bounds();
    add_pressure();
    add_shape();
    add_forces();
    return std::move(checks_);
  }

 private:
  /// value ≤ most, to the tolerance of all checks, relative to the larger of both and `size`.
  void at_most(const std::string& name, double value, double most, double size = 0) {
    const double slack = kCheckTolerance * std::max({std::abs(value), std::abs(most), size});
    checks_.push_back({name, value, most, value - most <= slack});
  }
  void at_least(const std::string& name, double value, double least, double size = 0) {
    const double slack = kCheckTolerance * std::max({std::abs(value), std::abs(least), size});
    checks_.push_back({name, value, least, least - value <= slack});
  }

  void add_bounds() {
    const auto& d = cam_.system.follower.dimensions;
    const double values[] = {d.base_radius,     d.offset, d.roller_radius,
                             d.centre_distance, d.arm,    d.face_offset};
    constexpr const char* kNames[] = {"bounds.base_radius",   "bounds.offset",
                                      "bounds.roller_radius", "bounds.centre_distance",
                                      "bounds.arm",           "bounds.face_offset"};
    for (int i = 0; i < kCamDimensions; ++i) {
      const CamLength& length = problem_.lengths[i];
      const bool positive = i != static_cast<int>(CamDimension::offset) &&
                            i != static_cast<int>(CamDimension::face_offset);
      const bool from_below =
          std::isfinite(length.bounds.min) && !(positive && length.bounds.min <= 0);
      const bool bounded = from_below || std::isfinite(length.bounds.max);
      if (!length.used || length.given || !bounded) continue;
      const double slack = kCheckTolerance * std::max(std::abs(values[i]), d.base_radius);
      const bool inside =
          values[i] >= length.bounds.min - slack && values[i] <= length.bounds.max + slack;
      checks_.push_back({kNames[i], values[i], length.bounds, inside});
    }
  }

  void add_pressure() {
    const CamConstraints& c = problem_.constraints;
    const double radian = degrees(1);
    const auto check = [&](const char* name, const std::optional<FoundAt>& found, double most) {
      at_most(name, radian * (found ? found->value : 0), radian * most, radian);
    };
    if (c.pressure_angle_max) {
      check("pressure_angle_deg_max", greatest_pressure_angle(cam_), *c.pressure_angle_max);
    }
    if (c.pressure_angle_max_rise) {
      check("pressure_angle_deg_max_rise", pressure_angle_of(cam_, Stretch::rises),
            *c.pressure_angle_max_rise);
    }
    if (c.pressure_angle_max_return) {
      check("pressure_angle_deg_max_return", pressure_angle_of(cam_, Stretch::falls),
            *c.pressure_angle_max_return);
    }
  }

  void add_shape() {
    const CamConstraints& c = problem_.constraints;
    const double size = cam_.system.follower.dimensions.base_radius;
    if (c.curvature_radius_min) {
      const auto convex = least_convex_radius(cam_);
      const bool undercut = *c.curvature_radius_min == 0;
      if (convex) {
        at_least(undercut ? "no_undercut" : "curvature_radius_min", convex->value,
                 *c.curvature_radius_min, size);
      }
    }
    if (c.concave_radius_min) {
      const auto concave = least_concave_radius(cam_);
      if (concave) at_least("concave_radius_min", concave->value, *c.concave_radius_min, size);
    }
    if (c.face_width_max) at_most("face_width_max", face_width(cam_), *c.face_width_max, size);
    if (c.profile_radius_min) {
      at_least("profile_radius_min", least_profile_radius(cam_).value, *c.profile_radius_min, size);
    }
    if (c.profile_radius_max) {
      at_most("profile_radius_max", greatest_profile_radius(cam_).value, *c.profile_radius_max,
              size);
    }
  }

  void add_forces() {
    const CamConstraints& c = problem_.constraints;
    const bool pressed = problem_.second.closure == cam::Closure::force;
    if (problem_.has_operation && problem_.preload && c.no_separation && pressed) {
      const double size = std::abs(greatest_force(cam_).value);
      at_least("no_separation", least_demand(cam_).value, 0, size);
    }
    if (c.contact_force_max) {
      at_most("contact_force_max", greatest_force(cam_).value, *c.contact_force_max);
    }
    if (c.torque_max) {
      at_most("torque_max", std::abs(greatest_torque(cam_).value), *c.torque_max);
    }
    if (c.contact_stress_max) {
      at_most("contact_stress_max", greatest_stress(cam_).value, *c.contact_stress_max);
    }
  }

  const CamProblem& problem_;
  const CamDesign& design_;
  const cam::Cam& cam_;
  std::vector<ConstraintCheck> checks_;
};

}  // namespace

std::vector<Fact> cam_facts(const CamProblem& problem, const CamDesign& design) {
  return Facts(problem, design).all();
}

std::vector<ConstraintCheck> cam_checks(const CamProblem& problem, const CamDesign& design) {
  return Checks(problem, design).all();
}

double least_preload(const cam::Cam& cam) {
  return std::max(0.0, cam.system.operation.preload - least_demand(cam).value);
}

}  // namespace cognate::problems
