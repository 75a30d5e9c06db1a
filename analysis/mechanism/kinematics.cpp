#include "analysis/mechanism/kinematics.hpp"

#include <cmath>

#include "analysis/numbers/angle.hpp"

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
  if (driven_by_length(mechanism.drive)) {
    return {.direction = {1, 0}, .displacement = coordinate};
  }
  return {.direction = unit_vector(coordinate), .displacement = 0};
}

}  // namespace cognate
