/// @file What a batch of evaluations can compute, and the sets of quantities that are compiled.
#pragma once

#include <cstddef>

namespace cognate {

/// The dimensions of a four-bar, in the order of the columns of a gradient. The pivots' distance is
/// the frame; the crank angle counts from A→D, so that moving a pivot turns the crank as well. The
/// derivative by the crank angle is the velocity.
enum class DesignVariable {
  pivot_a_x,
  pivot_a_y,
  pivot_d_x,
  pivot_d_y,
  crank,
  coupler,
  rocker,
  point_u,
  point_v
};
inline constexpr std::size_t kDesignVariables = 9;

namespace batch {

/// Sets of quantities are sums of these.
enum Quantity : unsigned {
  position = 1,
  velocity = 2,
  acceleration = 4,
  curvature = 8,
  transmission = 16,
  gradient = 32
};

/// The columns of an evaluation; of the gradient, x by each variable and then y by each.
enum Column : std::size_t {
  column_x,
  column_y,
  column_velocity_x,
  column_velocity_y,
  column_acceleration_x,
  column_acceleration_y,
  column_curvature,
  column_transmission_sin,
  column_transmission_cos,
  column_gradient_x,
  column_gradient_y = column_gradient_x + kDesignVariables
};
inline constexpr std::size_t kColumns = column_gradient_y + kDesignVariables;

/// Compiled is each of the four levels of motion, with and without transmission and gradient, and
/// transmission alone. A set of requested quantities is served by the smallest of these that holds
/// it.
inline constexpr unsigned kLevels[] = {position, position + velocity,
                                       position + velocity + acceleration,
                                       position + velocity + acceleration + curvature};
inline constexpr std::size_t kInstances = 17;

/// The quantities of the compiled instance `index` < kInstances.
constexpr unsigned instance_quantities(std::size_t index) {
  if (index == kInstances - 1) return transmission;
  return kLevels[index % 4] + (index & 4 ? unsigned{transmission} : 0) +
         (index & 8 ? unsigned{gradient} : 0);
}

/// The index of the smallest compiled instance that gives all of `wanted`.
constexpr std::size_t instance_for(unsigned wanted) {
  if (wanted == transmission) return kInstances - 1;
  const std::size_t level = wanted & curvature      ? 3
                            : wanted & acceleration ? 2
                            : wanted & velocity     ? 1
                                                    : 0;
  return level + (wanted & transmission ? 4 : 0) + (wanted & gradient ? 8 : 0);
}

}  // namespace batch
}  // namespace cognate
