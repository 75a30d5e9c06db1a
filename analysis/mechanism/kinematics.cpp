#include "analysis/mechanism/kinematics.hpp"

#include <cmath>

namespace cognate {

std::vector<double> sides(const Mechanism<double>& mechanism) {
  std::vector<double> result;
  result.reserve(mechanism.dyads.size());
  for (const Dyad<double>& dyad : mechanism.dyads) {
    result.push_back(std::visit(
        [](const auto& group) {
          if constexpr (requires { group.assembly; }) return sign(group.assembly);
          return 1.0;
        },
        dyad));
  }
  return result;
}

DrivePosition<double> drive_position(const Mechanism<double>& mechanism, double coordinate) {
  if (std::holds_alternative<DrivingSlider<double>>(mechanism.drive)) {
    return {.direction = {1, 0}, .displacement = coordinate};
  }
  return {.direction = {std::cos(coordinate), std::sin(coordinate)}, .displacement = 0};
}

Mechanism<double> as_mechanism(const FourBar& linkage) {
  Mechanism<double> mechanism;
  mechanism.drive = Crank<double>{linkage.pivot_a, linkage.crank};
  mechanism.dyads.emplace_back(Rrr<double>{{1, {linkage.crank, 0}},
                                           {0, linkage.pivot_d},
                                           linkage.coupler,
                                           linkage.rocker,
                                           linkage.assembly});
  return mechanism;
}

}  // namespace cognate
