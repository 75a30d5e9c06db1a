/// @file A four-bar with masses and loads, by the analysis kernel.
#pragma once

#include <vector>

#include "analysis/linkage/four_bar.hpp"
#include "analysis/mechanism/inverse_dynamics.hpp"
#include "analysis/mechanism/kinematics.hpp"
#include "problems/linkage/cycle/operation.hpp"

namespace cognate::problems {

/// Where on the linkage's bodies a place of it is.
Attached<double> attached(const FourBar& linkage, const LinkPlace& place);

/// Numbers are those of the crank angle, from the x axis, that was last moved to.
class LinkageDynamics {
 public:
  LinkageDynamics(const FourBar& linkage, const Operation& operation);

  /// Whether the linkage closes there.
  bool move_to(double crank_angle) { return motion_.move_to(crank_angle); }

  /// The driving torque, counter-clockwise, at the operation's speed.
  double driving_torque() const { return drive({speed_, 0}); }
  /// Of loads and weights alone, at the crank.
  double working_torque() const { return -drive({0, 0}); }
  /// Of the links alone, at the crank: what more is requested with an acceleration of one.
  double inertia() const { return drive({0, 1}) - drive({0, 0}); }
  /// The rocker's angle by the crank's, to first order.
  double rocker_rate() const { return motion_.bodies()[3].turn[0]; }

 private:
  double drive(const DriveRate& rate) const;

  MechanismMotion<2> motion_;
  InverseDynamics dynamics_;
  double speed_;
  std::vector<Load> forward_, backward_;  ///< that act while the rocker turns ccw, and cw
};

}  // namespace cognate::problems
