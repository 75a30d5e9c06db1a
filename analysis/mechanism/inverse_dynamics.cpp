#include "analysis/mechanism/inverse_dynamics.hpp"

#include <array>
#include <cstddef>

namespace cognate {
namespace {

/// Second time derivative of what has the derivatives `motion` by the drive coordinate.
template <class Motion>
auto acceleration(const Motion& motion, const DriveRate& rate) {
  constexpr auto order = std::tuple_size_v<Motion> - 1;
  auto sum = rate.acceleration * motion[1];
  if constexpr (order >= 2) sum = sum + (rate.speed * rate.speed) * motion[2];
  return sum;
}

/// The same of a body's angle, whose first derivative is turn[0].
template <int Order>
double angular_acceleration(const BodyMotion<double, Order>& body, const DriveRate& rate) {
  double sum = rate.acceleration * body.turn[0];
  if constexpr (Order > 1) sum += rate.speed * rate.speed * body.turn[1];
  return sum;
}

template <class T>
const T& at(std::span<const T> all, int index) {
  return all[static_cast<std::size_t>(index)];
}

}  // namespace

InverseDynamics::InverseDynamics(const Mechanism<double>& mechanism,
                                 std::span<const Inertia> inertias, const Vec2d& gravity)
    : balance_(mechanism), gravity_(gravity) {
  for (std::size_t body = 1; body < inertias.size(); ++body) {
    if (inertias[body].mass == 0 && inertias[body].moment == 0) continue;
    massive_.push_back({static_cast<int>(body), inertias[body]});
  }
}

template <int Order>
double InverseDynamics::drive(std::span<const BodyMotion<double, Order>> bodies,
                              const DriveRate& rate, std::span<const Load> loads) const {
  double work = 0;
  for (const auto& [number, inertia] : massive_) {
    const BodyMotion<double, Order>& body = at(bodies, number);
    const auto centre = point_motion(body, inertia.centre);
    work += inertia.mass * dot(acceleration(centre, rate) - gravity_, centre[1]) +
            inertia.moment * angular_acceleration(body, rate) * body.turn[0];
  }
  for (const Load& load : loads) {
    const BodyMotion<double, Order>& body = at(bodies, load.at.body);
    work -= dot(load.force, point_motion(body, load.at.at)[1]) + load.torque * body.turn[0];
  }
  return work;
}

template <int Order>
bool InverseDynamics::solve(std::span<const BodyMotion<double, Order>> bodies,
                            const DriveRate& rate, std::span<const Load> loads, Forces& forces) {
  const std::span<LoadedBody> loaded = balance_.bodies();
  for (std::size_t body = 1; body < loaded.size(); ++body) {
    loaded[body] = {bodies[body].direction, bodies[body].origin[0], {}};
  }
  for (const auto& [number, inertia] : massive_) {
    const BodyMotion<double, Order>& body = at(bodies, number);
    const Vec2d arm = body.direction * inertia.centre;
    const Vec2d force =
        inertia.mass * (acceleration(point_motion(body, inertia.centre), rate) - gravity_);
    loaded[static_cast<std::size_t>(number)].required = {
        force, inertia.moment * angular_acceleration(body, rate) + cross(arm, force)};
  }
  for (const Load& load : loads) {
    if (load.at.body == 0) continue;
    LoadedBody& body = loaded[static_cast<std::size_t>(load.at.body)];
    body.required.force = body.required.force - load.force;
    body.required.moment -= load.torque + cross(body.direction * load.at.at, load.force);
  }
  return balance_.solve(forces);
}

Forces InverseDynamics::forces() const {
  Forces forces;
  forces.reactions.resize(balance_.joints());
  return forces;
}

template double InverseDynamics::drive<1>(std::span<const BodyMotion<double, 1>>, const DriveRate&,
                                          std::span<const Load>) const;
template double InverseDynamics::drive<2>(std::span<const BodyMotion<double, 2>>, const DriveRate&,
                                          std::span<const Load>) const;
template double InverseDynamics::drive<3>(std::span<const BodyMotion<double, 3>>, const DriveRate&,
                                          std::span<const Load>) const;
template bool InverseDynamics::solve<1>(std::span<const BodyMotion<double, 1>>, const DriveRate&,
                                        std::span<const Load>, Forces&);
template bool InverseDynamics::solve<2>(std::span<const BodyMotion<double, 2>>, const DriveRate&,
                                        std::span<const Load>, Forces&);
template bool InverseDynamics::solve<3>(std::span<const BodyMotion<double, 3>>, const DriveRate&,
                                        std::span<const Load>, Forces&);

}  // namespace cognate
