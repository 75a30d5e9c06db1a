#include "problems/machine/gearing.hpp"

#include <algorithm>

#include "problems/train/transmission.hpp"

namespace cognate::problems {
namespace {

/// What passes back through a self-locking train where the load pushes it: so little that the speed
/// stays that at which the motor gives no torque, and not nothing, so that torques are continuous.
constexpr double kHolding = 1e-2;

Transmission transmission_of(const MotorTrain& train) {
  return transmission(train.train, {train.input, train.output, train.state}).value();
}

}  // namespace

double MotorGearing::torque_at_drive(double torque, double omega, double load) const {
  const double ideal = ratio * torque;
  if (torque != 0 && (ideal > 0) == (omega > 0)) return ideal * efficiency;
  if (!is_self_locking()) return ideal / reverse_efficiency;
  if (torque != 0) return ideal / kHolding;
  return omega > 0 ? -std::max(0.0, load) : -std::min(0.0, load);
}

MotorGearing gearing_of(const Motor& motor) {
  if (!motor.train) return {motor.ratio, motor.efficiency, motor.efficiency, 0};
  const Transmission found = transmission_of(*motor.train);
  const auto ratio = found.ratio.convert_to<double>();
  return {motor.train->reversed ? -ratio : ratio, found.efficiency, found.reverse_efficiency,
          found.output_inertia};
}

double motor_inertia(const Motor& motor) {
  const MotorGearing gearing = gearing_of(motor);
  return motor.inertia * gearing.ratio * gearing.ratio + gearing.inertia;
}

std::vector<Quantity> train_quantities(const Motor& motor) {
  if (!motor.train) return {};
  const Transmission found = transmission_of(*motor.train);
  std::vector<Quantity> all{{"train_ratio", found.ratio.convert_to<double>()}};
  constexpr std::size_t kLongest = 40;
  if (std::string exact = found.ratio.str(); exact.size() <= kLongest) {
    all.push_back({"train_ratio_exact", std::move(exact)});
  }
  all.push_back({"train_efficiency", found.efficiency});
  const bool locks = found.reverse_efficiency == 0;
  if (!locks) all.push_back({"train_reverse_efficiency", found.reverse_efficiency});
  all.push_back({"train_self_locking", locks});
  all.push_back({"train_inertia_kg_m2", found.output_inertia});
  return all;
}

}  // namespace cognate::problems
