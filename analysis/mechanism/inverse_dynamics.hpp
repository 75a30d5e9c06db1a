/// @file Inverse dynamics: from the motion of a mechanism to the forces in its joints and drive.
#pragma once

#include <span>
#include <vector>

#include "analysis/mechanism/forces.hpp"
#include "analysis/mechanism/joint_balance.hpp"
#include "analysis/mechanism/mechanism.hpp"
#include "analysis/mechanism/motion_state.hpp"

namespace cognate {

/// The inverse dynamics of one mechanism, prepared once for any number of positions; at a
/// position nothing is allocated. Copies are independent: one for each thread.
///
/// `bodies` are as evaluate<Order> gives them. A drive at rest (speed 0) needs Order 1, one that
/// moves Order 2. Loads on the frame have no effect.
class InverseDynamics {
 public:
  /// `inertias`: one for each body (the frame's is not used), or none where no body has mass.
  /// `gravity`: the acceleration of free fall (m/s², global axes).
  InverseDynamics(const Mechanism<double>& mechanism, std::span<const Inertia> inertias,
                  const Vec2d& gravity = {});

  /// The driving torque or force alone, by virtual work (d'Alembert): with v′ and φ′ the
  /// derivatives by the drive coordinate,
  ///
  ///     Σ (m (a − g)·v′ + J α φ′) − Σ (F·v′ + M φ′).
  ///
  /// Shares no equation with `solve`. Not a number where the mechanism cannot be assembled.
  template <int Order>
  double drive(std::span<const BodyMotion<double, Order>> bodies, const DriveRate& rate,
               std::span<const Load> loads) const;

  /// Reactions, drive and shaking force by Newton's and Euler's equations of every body (Li & Xu
  /// 2011, chapter 2, has them for single mechanisms). `forces` is one that `forces()` made. False
  /// where the mechanism cannot be assembled or a dyad stands at a dead point: then not all forces
  /// are numbers.
  template <int Order>
  bool solve(std::span<const BodyMotion<double, Order>> bodies, const DriveRate& rate,
             std::span<const Load> loads, Forces& forces);

  /// Forces with room for the reactions of joints(mechanism).
  Forces forces() const;

 private:
  struct MassiveBody {
    int body = 0;
    Inertia inertia;
  };

  JointBalance balance_;
  Vec2d gravity_;
  std::vector<MassiveBody> massive_;
};

}  // namespace cognate
