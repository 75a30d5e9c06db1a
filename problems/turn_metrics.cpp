#include "problems/turn_metrics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "analysis/golden_section.hpp"
#include "analysis/mechanism/inverse_dynamics.hpp"
#include "analysis/mechanism/kinematics.hpp"

namespace cognate::problems {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The least value of `function` between two arguments that enclose one minimum, by the golden
/// section: at a kink as sharp as where it is smooth.
template <class Function>
double least_between(const Function& function, double from, double to) {
  constexpr int kSteps = 64;
  const auto found = golden_section(function, from, to, kSteps);
  const bool known = std::isfinite(found.at_low) && std::isfinite(found.at_high);
  return known ? found.least() : -kInfinity;
}

/// The least value of `function` over a turn of the crank; −∞ where it has none at some angle. The
/// table begins where the crank points along the frame: near a change point accelerations and
/// torques have peaks there that are too narrow to be met by chance.
template <class Function>
double least_over_turn(const FourBar& linkage, const Function& function) {
  constexpr int kAngles = 720;
  constexpr std::size_t kMostRefined = 24;
  constexpr double kStep = 2 * std::numbers::pi / kAngles;
  const double begin = frame_angle(linkage);
  std::array<double, kAngles> values{};
  for (int k = 0; k < kAngles; ++k) {
    values.at(static_cast<std::size_t>(k)) = function(begin + kStep * k);
    if (!std::isfinite(values.at(static_cast<std::size_t>(k)))) return -kInfinity;
  }
  const auto value = [&](int k) {
    return values.at(static_cast<std::size_t>((k + kAngles) % kAngles));
  };
  std::vector<int> minima;
  for (int k = 0; k < kAngles; ++k) {
    if (value(k) <= value(k - 1) && value(k) <= value(k + 1)) minima.push_back(k);
  }
  // What is constant but for rounding has hundreds.
  std::ranges::sort(minima, {}, value);
  if (minima.size() > kMostRefined) minima.resize(kMostRefined);
  double least = kInfinity;
  for (const int k : minima) {
    const double refined =
        least_between(function, begin + kStep * (k - 1), begin + kStep * (k + 1));
    least = std::min({least, value(k), refined});
  }
  return least;
}

Attached<double> attached(const FourBar& linkage, const LinkPlace& place) {
  const std::array lengths{linkage.crank, linkage.coupler, linkage.rocker};
  const auto link = static_cast<std::size_t>(place.link);
  const Vec2d at = place.at_coupler_point ? linkage.coupler_point.value_or(Vec2d{})
                                          : Vec2d{place.share * lengths.at(link), 0} + place.offset;
  return {1 + static_cast<int>(place.link), at};
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

/// Masses and loads on the links as they are.
class TorqueOfLinkage {
 public:
  TorqueOfLinkage(const FourBar& linkage, const Operation& operation)
      : motion_(as_mechanism(linkage)),
        dynamics_(motion_.mechanism(), inertias(linkage, operation), operation.gravity),
        rate_{operation.speed, 0} {
    for (const WorkingLoad& load : operation.loads) {
      loads_.push_back({attached(linkage, load.at), load.force, load.torque});
    }
  }

  double at(double crank_angle) {
    if (!motion_.move_to(crank_angle)) return std::numeric_limits<double>::quiet_NaN();
    return dynamics_.drive(motion_.bodies(), rate_, loads_);
  }

 private:
  static std::vector<Inertia> inertias(const FourBar& linkage, const Operation& operation) {
    const std::array lengths{linkage.crank, linkage.coupler, linkage.rocker};
    std::vector<Inertia> all(1);  // the frame
    for (std::size_t i = 0; i < lengths.size(); ++i) {
      const LinkMass& link = operation.links.at(i);
      const double rod = link.mass_per_length * lengths.at(i);
      all.push_back({link.mass + rod, attached(linkage, link.centre).at,
                     link.moment + rod * lengths.at(i) * lengths.at(i) / 12});
    }
    return all;
  }

  MechanismMotion<2> motion_;
  InverseDynamics dynamics_;
  DriveRate rate_;
  std::vector<Load> loads_;
};

}  // namespace

double clearance_distance(const FourBar& linkage, const Clearance& clearance) {
  MechanismMotion<0> motion(as_mechanism(linkage));
  const Attached<double> point = attached(linkage, clearance.point);
  return least_over_turn(linkage, [&](double angle) {
    if (!motion.move_to(angle)) return -kInfinity;
    const double inside = distance_inside(clearance.box, motion.point(point)[0]);
    return clearance.inside ? inside : -inside;
  });
}

double peak_acceleration(const FourBar& linkage, Accelerated accelerated, double speed) {
  MechanismMotion<2> motion(as_mechanism(linkage));
  const Attached<double> point = attached(linkage, MovingPoint::coupler_point);
  const double least = least_over_turn(linkage, [&](double angle) {
    if (!motion.move_to(angle)) return -kInfinity;
    return accelerated == Accelerated::rocker ? -std::abs(motion.bodies()[3].turn[1])
                                              : -norm(motion.point(point)[2]);
  });
  return -least * speed * speed;
}

double torque_ripple(const FourBar& linkage, const Operation& operation) {
  TorqueOfLinkage torque(linkage, operation);
  const double least = least_over_turn(linkage, [&](double angle) { return torque.at(angle); });
  const double most = -least_over_turn(linkage, [&](double angle) { return -torque.at(angle); });
  return most - least;
}

std::vector<std::string> skipped_evaluations(const Constraints& constraints) {
  if (constraints.torque_ripple_max) return {};
  if (constraints.peak_acceleration_max) return {"forces"};
  return {"velocities", "accelerations", "forces"};
}

void add_turn_metrics(const Constraints& constraints, const FourBar& linkage,
                      Accelerated accelerated, Metrics& metrics) {
  const Operation& operation = constraints.operation;
  if (constraints.peak_acceleration_max) {
    metrics.peak_acceleration = peak_acceleration(linkage, accelerated, operation.speed);
  }
  if (constraints.torque_ripple_max) metrics.torque_ripple = torque_ripple(linkage, operation);
}

}  // namespace cognate::problems
