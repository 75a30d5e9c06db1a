#include "problems/linkage/turn_metrics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/linkage/four_bar.hpp"
#include "analysis/mechanism/kinematics.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/linkage/linkage_dynamics.hpp"
#include "problems/linkage/turn_scan.hpp"

namespace cognate::problems {
namespace {

/// From where the crank points along the frame.
TurnScan scan_of(const FourBar& linkage) {
  return {frame_angle(linkage)};
}

double torque_at(LinkageDynamics& dynamics, double crank_angle) {
  if (!dynamics.move_to(crank_angle)) return std::numeric_limits<double>::quiet_NaN();
  return dynamics.driving_torque();
}

Attached<double> attached(const FourBar& linkage, MovingPoint point) {
  switch (point) {
    case MovingPoint::b:
      return {1, {linkage.crank, 0}};
    case MovingPoint::c:
      return {3, {linkage.rocker, 0}};
    case MovingPoint::coupler_point:
      break;
  }
  return {2, linkage.coupler_point.value_or(Vec2d{})};
}

double distance_inside(const Box& box, const Vec2d& p) {
  return std::min({p.x - box.min.x, box.max.x - p.x, p.y - box.min.y, box.max.y - p.y});
}

}  // namespace

double clearance_distance(const FourBar& linkage, const Clearance& clearance) {
  MechanismMotion<0> motion(as_mechanism(linkage));
  const Attached<double> point = attached(linkage, clearance.point);
  return scan_of(linkage).least([&](double angle) {
    if (!motion.move_to(angle)) return -kInfinity;
    const double inside = distance_inside(clearance.box, motion.point(point)[0]);
    return clearance.inside ? inside : -inside;
  });
}

double peak_acceleration(const FourBar& linkage, Accelerated accelerated, double speed) {
  MechanismMotion<2> motion(as_mechanism(linkage));
  const Attached<double> point = attached(linkage, MovingPoint::coupler_point);
  const double least = scan_of(linkage).least([&](double angle) {
    if (!motion.move_to(angle)) return -kInfinity;
    return accelerated == Accelerated::rocker ? -std::abs(motion.bodies()[3].turn[1])
                                              : -norm(motion.point(point)[2]);
  });
  return -least * speed * speed;
}

double torque_ripple(const FourBar& linkage, const Operation& operation) {
  const TurnScan scan = scan_of(linkage);
  LinkageDynamics dynamics(linkage, operation);
  const double least = scan.least([&](double angle) { return torque_at(dynamics, angle); });
  const double most = -scan.least([&](double angle) { return -torque_at(dynamics, angle); });
  return most - least;
}

double motor_power(const FourBar& linkage, const Operation& operation) {
  LinkageDynamics dynamics(linkage, operation);
  const double least = scan_of(linkage).least(
      [&](double angle) { return -operation.speed * torque_at(dynamics, angle); });
  return std::max(0., -least);
}

std::vector<std::string> skipped_evaluations(const Constraints& constraints) {
  if (constraints.torque_ripple_max || constraints.motor_power_max) return {};
  const bool of_energy = constraints.speed_fluctuation_max || constraints.flywheel_inertia_max;
  if (constraints.peak_acceleration_max) return {"forces"};
  if (of_energy) return {"accelerations", "forces"};
  return {"velocities", "accelerations", "forces"};
}

void add_turn_metrics(const Constraints& constraints, const FourBar& linkage,
                      Accelerated accelerated, Metrics& metrics) {
  const Operation& operation = constraints.operation;
  if (constraints.peak_acceleration_max) {
    metrics.peak_acceleration = peak_acceleration(linkage, accelerated, operation.speed);
  }
  if (constraints.torque_ripple_max) metrics.torque_ripple = torque_ripple(linkage, operation);
  if (constraints.speed_fluctuation_max) {
    metrics.speed_fluctuation = speed_fluctuation(linkage, operation);
  }
  if (constraints.flywheel_inertia_max) {
    metrics.flywheel_inertia = flywheel_inertia(linkage, operation);
  }
  if (constraints.motor_power_max) metrics.motor_power = motor_power(linkage, operation);
}

}  // namespace cognate::problems
