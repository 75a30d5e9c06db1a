/// @file Newton's and Euler's equations of all bodies as one dense system, over any number type.
#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include "analysis/mechanism/forces.hpp"
#include "analysis/mechanism/joints.hpp"
#include "analysis/mechanism/kinematics.hpp"

namespace cognate::test {

/// The solution of A x = b by elimination with row exchanges.
template <class T>
std::vector<T> solve_dense(std::vector<std::vector<T>> a, std::vector<T> b) {
  using std::abs;
  const std::size_t n = b.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < n; ++i) {
      if (abs(a[i][k]) > abs(a[pivot][k])) pivot = i;
    }
    std::swap(a[k], a[pivot]);
    std::swap(b[k], b[pivot]);
    for (std::size_t i = k + 1; i < n; ++i) {
      const T factor = a[i][k] / a[k][k];
      if (factor == 0) continue;
      for (std::size_t j = k; j < n; ++j) a[i][j] -= factor * a[k][j];
      b[i] -= factor * b[k];
    }
  }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t j = k + 1; j < n; ++j) b[k] -= a[k][j] * b[j];
    b[k] /= a[k][k];
  }
  return b;
}

/// Reactions of all joints and the drive.
template <class T>
struct DenseForces {
  std::vector<Vec2<T>> force;
  std::vector<T> moment;
  T drive{};
};

/// Three equations for each body, about its centre of mass; two unknowns for each joint as
/// joints(mechanism) describes it, and the drive.
template <class T>
class DenseBalance {
 public:
  DenseBalance(const Mechanism<double>& mechanism, std::vector<BodyMotion<T, 2>> bodies,
               std::vector<Inertia> inertias)
      : list_(joints(mechanism)), bodies_(std::move(bodies)), inertias_(std::move(inertias)) {
    const std::size_t unknowns = 2 * list_.joints.size() + 1;
    matrix_.assign(3 * (bodies_.size() - 1), std::vector<T>(unknowns, T(0)));
    for (std::size_t j = 0; j < list_.joints.size(); ++j) add_joint(list_.joints[j], 2 * j);
    if (std::holds_alternative<DrivingSlider<double>>(mechanism.drive)) {
      add(1, bodies_[1].direction, bodies_[1].origin[0], T(0), unknowns - 1);
    } else if (std::holds_alternative<DrivingRod<double>>(mechanism.drive)) {
      // The oil pushes the rod and, the other way, the cylinder.
      add(1, bodies_[2].direction, bodies_[1].origin[0], T(0), unknowns - 1);
      add(2, T(-1) * bodies_[2].direction, bodies_[1].origin[0], T(0), unknowns - 1);
    } else {
      add(1, {T(0), T(0)}, {T(0), T(0)}, T(1), unknowns - 1);
    }
  }

  DenseForces<T> solve(const DriveRate& rate, const std::vector<Load>& loads,
                       const Vec2d& gravity) const {
    std::vector<T> right(matrix_.size(), T(0));
    for (std::size_t i = 1; i < bodies_.size(); ++i) {
      const auto motion = point_motion(bodies_[i], centre(i));
      const T speed2 = T(rate.speed) * T(rate.speed), acceleration(rate.acceleration);
      const Vec2<T> a = speed2 * motion[2] + acceleration * motion[1];
      const T alpha = speed2 * bodies_[i].turn[1] + acceleration * bodies_[i].turn[0];
      right[3 * i - 3] = T(inertias_[i].mass) * (a.x - T(gravity.x));
      right[3 * i - 2] = T(inertias_[i].mass) * (a.y - T(gravity.y));
      right[3 * i - 1] = T(inertias_[i].moment) * alpha;
    }
    for (const Load& load : loads) {
      const auto i = static_cast<std::size_t>(load.at.body);
      const Vec2<T> force{T(load.force.x), T(load.force.y)};
      const Vec2<T> arm =
          bodies_[i].direction * (Vec2<T>{T(load.at.at.x), T(load.at.at.y)} - centre(i));
      right[3 * i - 3] -= force.x;
      right[3 * i - 2] -= force.y;
      right[3 * i - 1] -= T(load.torque) + cross(arm, force);
    }
    return named(solve_dense(matrix_, right));
  }

 private:
  Vec2<T> centre(std::size_t body) const {
    return {T(inertias_[body].centre.x), T(inertias_[body].centre.y)};
  }
  Vec2<T> place(std::size_t body, const Vec2<T>& at) const {
    return bodies_[body].origin[0] + bodies_[body].direction * at;
  }
  Vec2<T> place(const Joint& joint) const {
    return place(std::size_t(joint.at.body), {T(joint.at.at.x), T(joint.at.at.y)});
  }
  Vec2<T> across(const Joint& joint) const {
    return perp(bodies_[std::size_t(joint.at.body)].direction *
                Vec2<T>{T(joint.direction.x), T(joint.direction.y)});
  }
  /// A unit of the unknown `column` exerts this on `body`.
  void add(int body, const Vec2<T>& force, const Vec2<T>& at, const T& moment, std::size_t column) {
    if (body == 0) return;
    const auto i = static_cast<std::size_t>(body);
    const Vec2<T> arm = at - place(i, centre(i));
    matrix_[3 * i - 3][column] += force.x;
    matrix_[3 * i - 2][column] += force.y;
    matrix_[3 * i - 1][column] += moment + cross(arm, force);
  }
  void add_joint(const Joint& joint, std::size_t column) {
    const Vec2<T> at = place(joint);
    for (const int sign : {1, -1}) {
      const int body = sign > 0 ? joint.second : joint.first;
      if (joint.type == JointType::revolute) {
        add(body, {T(sign), T(0)}, at, T(0), column);
        add(body, {T(0), T(sign)}, at, T(0), column + 1);
      } else {
        add(body, T(sign) * across(joint), at, T(0), column);
        add(body, {T(0), T(0)}, at, T(sign), column + 1);
      }
    }
  }
  DenseForces<T> named(const std::vector<T>& x) const {
    DenseForces<T> forces;
    for (std::size_t j = 0; j < list_.joints.size(); ++j) {
      const Joint& joint = list_.joints[j];
      const bool turns = joint.type == JointType::revolute;
      forces.force.push_back(turns ? Vec2<T>{x[2 * j], x[2 * j + 1]} : x[2 * j] * across(joint));
      forces.moment.push_back(turns ? T(0) : x[2 * j + 1]);
    }
    forces.drive = x.back();
    return forces;
  }

  JointList list_;
  std::vector<BodyMotion<T, 2>> bodies_;
  std::vector<Inertia> inertias_;
  std::vector<std::vector<T>> matrix_;
};

}  // namespace cognate::test
