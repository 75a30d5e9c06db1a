#include "problems/linkage/cycle/cycle_metrics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "analysis/linkage/four_bar.hpp"
#include "analysis/mechanism/kinematics.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/linkage/cycle/cycle_scan.hpp"
#include "problems/linkage/cycle/linkage_dynamics.hpp"

namespace cognate::problems {
namespace {

/// From where the crank points along the frame.
CycleScan scan_of(const FourBar& linkage) {
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

/// The greatest derivative of the output by the crank's angle, of order 1 or 2.
template <int Order>
double peak_derivative(const FourBar& linkage, CycleOutput output) {
  MechanismMotion<Order> motion(as_mechanism(linkage));
  const Attached<double> point = attached(linkage, MovingPoint::coupler_point);
  return -scan_of(linkage).least([&](double angle) {
    if (!motion.move_to(angle)) return -kInfinity;
    return output == CycleOutput::rocker ? -std::abs(motion.bodies()[3].turn[Order - 1])
                                         : -norm(motion.point(point)[Order]);
  });
}

double peak_speed(const FourBar& linkage, CycleOutput output, const Operation& operation) {
  return peak_derivative<1>(linkage, output) * std::abs(operation.speed);
}

double peak_acceleration(const FourBar& linkage, CycleOutput output, const Operation& operation) {
  return peak_derivative<2>(linkage, output) * operation.speed * operation.speed;
}

double torque_ripple(const FourBar& linkage, CycleOutput, const Operation& operation) {
  const CycleScan scan = scan_of(linkage);
  LinkageDynamics dynamics(linkage, operation);
  const double least = scan.least([&](double angle) { return torque_at(dynamics, angle); });
  const double most = -scan.least([&](double angle) { return -torque_at(dynamics, angle); });
  return most - least;
}

double peak_torque(const FourBar& linkage, CycleOutput, const Operation& operation) {
  LinkageDynamics dynamics(linkage, operation);
  return -scan_of(linkage).least([&](double angle) {
    const double torque = torque_at(dynamics, angle);
    return std::isnan(torque) ? -kInfinity : -std::abs(torque);
  });
}

double motor_power(const FourBar& linkage, CycleOutput, const Operation& operation) {
  LinkageDynamics dynamics(linkage, operation);
  const double least = scan_of(linkage).least(
      [&](double angle) { return -operation.speed * torque_at(dynamics, angle); });
  return std::max(0., -least);
}

/// A quantity of the steady motion.
template <double (*Of)(const FourBar&, const Operation&)>
double steady(const FourBar& linkage, CycleOutput, const Operation& operation) {
  return Of(linkage, operation);
}

/// In the order of the quantities.
constexpr std::array kMetrics{peak_speed,
                              peak_acceleration,
                              torque_ripple,
                              peak_torque,
                              steady<rms_torque>,
                              steady<speed_fluctuation>,
                              steady<flywheel_inertia>,
                              motor_power};
static_assert(kMetrics.size() == kCycleQuantities.size());

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

double cycle_metric(CycleQuantity quantity, const FourBar& linkage, CycleOutput output,
                    const Operation& operation) {
  return kMetrics.at(index_of(quantity))(linkage, output, operation);
}

std::vector<std::string> skipped_evaluations(const Constraints& constraints) {
  MotionLevel needed = MotionLevel::positions;
  for (const CycleDeclaration& quantity : kCycleQuantities) {
    if (constraints.cycle_max[quantity.id]) needed = std::max(needed, quantity.level);
  }
  std::vector<std::string> skipped;
  for (const auto& [level, name] : {std::pair(MotionLevel::velocities, "velocities"),
                                    std::pair(MotionLevel::accelerations, "accelerations"),
                                    std::pair(MotionLevel::forces, "forces")}) {
    if (level > needed) skipped.emplace_back(name);
  }
  return skipped;
}

void add_cycle_metrics(const Constraints& constraints, const FourBar& linkage, CycleOutput output,
                       Metrics& metrics) {
  for (const CycleDeclaration& quantity : kCycleQuantities) {
    if (!constraints.cycle_max[quantity.id]) continue;
    metrics.cycle[quantity.id] = cycle_metric(quantity.id, linkage, output, constraints.operation);
  }
}

}  // namespace cognate::problems
