#include <algorithm>
#include <cmath>

#include "problems/basics/degrees.hpp"
#include "problems/basics/names.hpp"
#include "problems/cam/extremes.hpp"
#include "problems/cam/quantities.hpp"
#include "problems/cam/second_contact.hpp"
#include "problems/linkage/verify.hpp"

namespace cognate::problems {
namespace {

using cam::MotionPart;

class Checks {
 public:
  Checks(const CamProblem& problem, const CamDesign& design, const CamExtremes& extremes)
      : problem_(problem), design_(design), extremes_(extremes), cam_(extremes.cam()) {}

  std::vector<ConstraintCheck> all() && {
    add_bounds();
    add_assembly();
    add_pressure();
    add_shape();
    add_second_contact();
    add_forces();
    return std::move(checks_);
  }

 private:
  /// value ≤ most, to the tolerance of all checks, relative to the larger of both and `size`.
  void at_most(const std::string& name, double value, double most, double size = 0) {
    const double slack = kCheckTolerance * std::max({std::abs(value), std::abs(most), size});
    checks_.push_back({name, value, most, std::isfinite(value) && value - most <= slack});
  }
  void at_least(const std::string& name, double value, double least, double size = 0) {
    const double slack = kCheckTolerance * std::max({std::abs(value), std::abs(least), size});
    checks_.push_back({name, value, least, std::isfinite(value) && least - value <= slack});
  }

  void add_bounds() {
    const auto& d = cam_.system.follower.dimensions;
    const double values[] = {d.base_radius,     d.offset, d.roller_radius,
                             d.centre_distance, d.arm,    d.face_offset};
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
      checks_.push_back({"bounds." + std::string(to_string(static_cast<CamDimension>(i))),
                         values[i], length.bounds, inside});
    }
  }

  /// Reported only where it fails: the follower stays on its side of the cam's centre, and a
  /// roller clear of it.
  void add_assembly() {
    const auto& d = cam_.system.follower.dimensions;
    if (problem_.follower != cam::FollowerType::translating_flat) {
      const double along = extremes_.least_along();
      if (!(along > 0)) checks_.push_back({"assembly", along, 0.0, false});
    }
    if (d.roller_radius >= d.base_radius) at_most("roller_radius", d.roller_radius, d.base_radius);
  }

  void add_pressure() {
    const CamConstraints& c = problem_.constraints;
    const double radian = degrees(1);
    const auto check = [&](const char* name, const std::optional<ValueAt>& found, double most) {
      at_most(name, radian * (found ? found->value : 0), radian * most, radian);
    };
    if (c.pressure_angle_max) {
      check("pressure_angle_deg_max", extremes_.pressure_angle(), *c.pressure_angle_max);
    }
    if (c.pressure_angle_max_rise) {
      check("pressure_angle_deg_max_rise", extremes_.pressure_angle(MotionPart::rises),
            *c.pressure_angle_max_rise);
    }
    if (c.pressure_angle_max_return) {
      check("pressure_angle_deg_max_return", extremes_.pressure_angle(MotionPart::falls),
            *c.pressure_angle_max_return);
    }
    if (c.pressure_angle_max_rise_working) {
      check("pressure_angle_deg_max_rise_working",
            extremes_.working_pressure_angle(MotionPart::rises),
            *c.pressure_angle_max_rise_working);
    }
    if (c.pressure_angle_max_return_working) {
      check("pressure_angle_deg_max_return_working",
            extremes_.working_pressure_angle(MotionPart::falls),
            *c.pressure_angle_max_return_working);
    }
  }

  void add_shape() {
    const CamConstraints& c = problem_.constraints;
    const double size = cam_.system.follower.dimensions.base_radius;
    if (c.curvature_radius_min) {
      const auto convex = extremes_.convex_radius();
      const bool undercut = *c.curvature_radius_min == 0;
      if (convex) {
        at_least(undercut ? "no_undercut" : "curvature_radius_min", convex->value,
                 *c.curvature_radius_min, size);
      }
    }
    if (c.concave_radius_min) {
      const auto concave = extremes_.concave_radius();
      if (concave) at_least("concave_radius_min", concave->value, *c.concave_radius_min, size);
    }
    if (c.face_width_max)
      at_most("face_width_max", extremes_.face_width(), *c.face_width_max, size);
    if (c.profile_radius_min) {
      at_least("profile_radius_min", extremes_.least_profile_radius(), *c.profile_radius_min, size);
    }
    if (c.profile_radius_max) {
      at_most("profile_radius_max", extremes_.greatest_profile_radius(), *c.profile_radius_max,
              size);
    }
  }

  /// What a form-closed follower needs besides.
  void add_second_contact() {
    const SecondContact& second = problem_.second;
    const auto& d = cam_.system.follower.dimensions;
    switch (second.closure) {
      case cam::Closure::force:
        return;
      case cam::Closure::groove: {
        const auto concave = extremes_.concave_radius();
        const auto& least = problem_.constraints.curvature_radius_min;
        if (concave && least) {
          at_least(*least == 0 ? "no_undercut.outer_wall" : "curvature_radius_min.outer_wall",
                   concave->value - 2 * d.roller_radius, *least, d.base_radius);
        }
        return;
      }
      case cam::Closure::conjugate:
        return add_second_cam();
      case cam::Closure::constant_breadth: {
        const double deviation = breadth_fault(cam_.programme).deviation;
        at_most("constant_breadth", std::abs(deviation), 0, cam_.programme.highest());
        const double breadth = constant_breadth(cam_);
        if (second.breadth) {
          const bool equal = std::abs(breadth - *second.breadth) <= kCheckTolerance * breadth;
          checks_.push_back({"follower.breadth", breadth, *second.breadth, equal});
        }
        return;
      }
    }
  }

  /// The other cam of a conjugate pair keeps the same limits.
  void add_second_cam() {
    if (!design_.second) {
      checks_.push_back(
          {"second_cam", std::string("none"), std::string("clear of the shaft"), false});
      return;
    }
    const CamConstraints& c = problem_.constraints;
    const CamExtremes second(*design_.second);
    const double size = design_.second->system.follower.dimensions.base_radius;
    if (c.pressure_angle_max) {
      at_most("second_cam.pressure_angle_deg_max", degrees(second.pressure_angle().value),
              degrees(*c.pressure_angle_max), degrees(1));
    }
    const auto convex = second.convex_radius();
    if (c.curvature_radius_min && convex) {
      at_least("second_cam.curvature_radius_min", convex->value, *c.curvature_radius_min, size);
    }
    if (const auto concave = second.concave_radius(); c.concave_radius_min && concave) {
      at_least("second_cam.concave_radius_min", concave->value, *c.concave_radius_min, size);
    }
    if (c.profile_radius_min) {
      at_least("second_cam.profile_radius_min", second.least_profile_radius(),
               *c.profile_radius_min, size);
    }
    if (c.profile_radius_max) {
      at_most("second_cam.profile_radius_max", second.greatest_profile_radius(),
              *c.profile_radius_max, size);
    }
    if (c.contact_force_max) {
      at_most("second_cam.contact_force_max", second.contact_force(false).value,
              *c.contact_force_max);
    }
    if (c.contact_stress_max) {
      at_most("second_cam.contact_stress_max", second.stress().value, *c.contact_stress_max);
    }
  }

  void add_forces() {
    const CamConstraints& c = problem_.constraints;
    const bool pressed = problem_.second.closure == cam::Closure::force;
    if (problem_.has_operation && problem_.preload && c.no_separation && pressed) {
      const double size = std::abs(extremes_.contact_force(false).value);
      at_least("no_separation", extremes_.least_demand().value, 0, size);
    }
    if (c.contact_force_max) {
      at_most("contact_force_max", extremes_.contact_force(presses_both_ways()).value,
              *c.contact_force_max);
    }
    if (c.torque_max) {
      at_most("torque_max", std::abs(extremes_.torque().value), *c.torque_max);
    }
    if (c.contact_stress_max) {
      at_most("contact_stress_max", extremes_.stress().value, *c.contact_stress_max);
    }
  }

  /// Whether one cam takes the forces of both senses; of a conjugate pair each takes one.
  bool presses_both_ways() const {
    return problem_.second.closure == cam::Closure::groove ||
           problem_.second.closure == cam::Closure::constant_breadth;
  }

  const CamProblem& problem_;
  const CamDesign& design_;
  const CamExtremes& extremes_;
  const cam::Cam& cam_;
  std::vector<ConstraintCheck> checks_;
};

}  // namespace

std::vector<ConstraintCheck> cam_checks(const CamProblem& problem, const CamDesign& design,
                                        const CamExtremes& extremes) {
  return Checks(problem, design, extremes).all();
}

}  // namespace cognate::problems
