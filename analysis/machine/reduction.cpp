#include "analysis/machine/reduction.hpp"

#include <cstddef>

namespace cognate::machine {

EquivalentInertia equivalent_inertia(std::span<const BodyMotion<double, 2>> bodies,
                                     std::span<const Inertia> inertias) {
  EquivalentInertia sum;
  for (std::size_t body = 1; body < inertias.size(); ++body) {
    const auto& [mass, centre, moment] = inertias[body];
    if (mass == 0 && moment == 0) continue;
    const auto path = point_motion(bodies[body], centre);
    const auto& turn = bodies[body].turn;
    sum.value += mass * squared_norm(path[1]) + moment * turn[0] * turn[0];
    sum.slope += 2 * (mass * dot(path[1], path[2]) + moment * turn[0] * turn[1]);
  }
  return sum;
}

double weight_torque(std::span<const BodyMotion<double, 2>> bodies,
                     std::span<const Inertia> inertias, const Vec2d& gravity) {
  double sum = 0;
  for (std::size_t body = 1; body < inertias.size(); ++body) {
    const auto& [mass, centre, moment] = inertias[body];
    if (mass != 0) sum += mass * dot(gravity, point_motion(bodies[body], centre)[1]);
  }
  return sum;
}

double load_torque(std::span<const BodyMotion<double, 2>> bodies, std::span<const Load> loads) {
  double sum = 0;
  for (const Load& load : loads) {
    const BodyMotion<double, 2>& body = bodies[static_cast<std::size_t>(load.at.body)];
    sum += dot(load.force, point_motion(body, load.at.at)[1]) + load.torque * body.turn[0];
  }
  return sum;
}

}  // namespace cognate::machine
