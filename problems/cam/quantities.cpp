#include "problems/cam/quantities.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "analysis/cam/profile.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/cam/extremes.hpp"
#include "problems/cam/second_contact.hpp"
#include "problems/linkage/verify.hpp"

namespace cognate::problems {
namespace {

using cam::MotionPart;

class Facts {
 public:
  Facts(const CamProblem& problem, const CamDesign& design, const CamExtremes& extremes)
      : problem_(problem), design_(design), extremes_(extremes), cam_(extremes.cam()) {}

  std::vector<Quantity> all() && {
    add_motion();
    add_pressure();
    add_shape();
    add_second_contact();
    add_forces();
    return std::move(quantities_);
  }

 private:
  void add(const char* name, double value) { quantities_.push_back({name, value}); }
  void add_at(const std::string& name, const ValueAt& found, double unit = 1) {
    quantities_.push_back({name, unit * found.value});
    quantities_.push_back({name + "_at_deg", degrees(found.angle)});
  }

  /// The follower's greatest displacement, and at a given speed its velocity and acceleration.
  void add_motion() {
    const bool swings = is_oscillating(problem_.follower);
    const double highest = cam_.programme.highest();
    add(swings ? "swing_deg" : "stroke", swings ? degrees(highest) : highest);
    const double speed = problem_.operation.speed;
    if (!(speed > 0)) return;
    const auto peak = [&](double cam::FollowerMotion<double>::*derivative, double unit) {
      ValueAt found = extremes_.motion(derivative);
      found.value *= unit;
      return found;
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
    add_at("pressure_angle_deg_max", extremes_.pressure_angle(), degrees(1));
    const auto rise = extremes_.pressure_angle(MotionPart::rises);
    const auto fall = extremes_.pressure_angle(MotionPart::falls);
    if (rise) add_at("pressure_angle_deg_max_rise", *rise, degrees(1));
    if (fall) add_at("pressure_angle_deg_max_return", *fall, degrees(1));
    const auto pushes = extremes_.working_pressure_angle(MotionPart::rises);
    const auto follows = extremes_.working_pressure_angle(MotionPart::falls);
    if (pushes) add_at("pressure_angle_deg_max_rise_working", *pushes, degrees(1));
    if (follows) add_at("pressure_angle_deg_max_return_working", *follows, degrees(1));
  }

  /// The prime circle, on which the pitch curve of a roller lies at displacement 0, and the base
  /// circle, on which the profile does.
  void add_circles(const std::string& cam, const cam::CamDimensions<double>& dimensions) {
    const auto& [prime, roller] = std::tie(dimensions.base_radius, dimensions.roller_radius);
    if (roller > 0) quantities_.push_back({cam + "prime_radius", prime});
    quantities_.push_back({cam + "base_radius", prime - roller});
  }

  void add_shape() {
    add_circles("", cam_.system.follower.dimensions);
    const auto convex = extremes_.convex_radius(), concave = extremes_.concave_radius();
    if (convex) add_at("curvature_radius_min", *convex);
    if (concave) add_at("concave_radius_min", *concave);
    const double rounding = kCheckTolerance * cam_.system.follower.dimensions.base_radius;
    const bool turns_back = convex && convex->value < -rounding;
    quantities_.push_back({"undercut", turns_back || profile_crosses_itself()});
    add("profile_radius_min", extremes_.least_profile_radius());
    add("profile_radius_max", extremes_.greatest_profile_radius());
    if (is_flat(problem_.follower)) add("face_width", extremes_.face_width());
  }

  /// The second cam of a conjugate pair, the distance of parallel faces.
  void add_second_contact() {
    if (problem_.second.closure == cam::Closure::constant_breadth) {
      add("breadth", constant_breadth(cam_));
    }
    if (!design_.second) return;
    const cam::Cam& second = *design_.second;
    add_circles("second_cam_", second.system.follower.dimensions);
    const CamExtremes extremes(second);
    add_at("second_cam_pressure_angle_deg_max", extremes.pressure_angle(), degrees(1));
    const auto convex = extremes.convex_radius();
    if (convex) add_at("second_cam_curvature_radius_min", *convex);
    if (problem_.has_operation)
      add_at("second_cam_contact_force_max", extremes.contact_force(false));
    if (!problem_.has_contact) return;
    const ValueAt stress = extremes.stress();
    if (std::isfinite(stress.value)) add_at("second_cam_contact_stress_max", stress);
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
      add_at(known ? "roller_speed_max" : "roller_speed_ratio_max", extremes_.roller_speed(),
             known ? speed : 1);
    }
    if (!problem_.has_operation) return;
    if (problem_.second.closure == cam::Closure::force) {
      add("preload", design_.operation.preload);
      add("preload_min", least_preload(cam_));
    }
    const bool presses_both_ways = problem_.second.closure == cam::Closure::groove ||
                                   problem_.second.closure == cam::Closure::constant_breadth;
    add_at("demand_min", extremes_.least_demand());
    add_at("contact_force_max", extremes_.contact_force(presses_both_ways));
    add_at("torque_max", extremes_.torque());
    if (!problem_.has_contact) return;
    const ValueAt stress = extremes_.stress();
    if (std::isfinite(stress.value)) add_at("contact_stress_max", stress);
  }

  const CamProblem& problem_;
  const CamDesign& design_;
  const CamExtremes& extremes_;
  const cam::Cam& cam_;
  std::vector<Quantity> quantities_;
};

}  // namespace

std::vector<Quantity> cam_quantities(const CamProblem& problem, const CamDesign& design,
                                     const CamExtremes& extremes) {
  return Facts(problem, design, extremes).all();
}

double least_preload(const cam::Cam& cam) {
  return std::max(0.0, cam.system.operation.preload - CamExtremes(cam).least_demand().value);
}

}  // namespace cognate::problems
