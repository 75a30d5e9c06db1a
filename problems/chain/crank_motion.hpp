/// @file A chain at any angle of its crank.
#pragma once

#include <span>
#include <variant>

#include "analysis/mechanism/followed_motion.hpp"
#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::problems {

/// A chain moved to any angle of its crank; one with a three-pin link to where a motion over the
/// whole turn leads it.
class CrankMotion {
 public:
  explicit CrankMotion(const Mechanism<double>& mechanism) : motion_(motion_of(mechanism)) {}

  /// Whether every body has a place there.
  bool move_to(double crank) {
    if (auto* closed = std::get_if<MechanismMotion<0>>(&motion_)) return closed->move_to(crank);
    return std::get<FollowedMotion<0>>(motion_).move_to(in_one_turn(crank));
  }

  /// Where bodies and points are after `move_to`.
  std::span<const BodyMotion<double, 0>> bodies() const {
    return std::visit([](const auto& motion) { return motion.bodies(); }, motion_);
  }
  Vec2d point(const Attached<double>& point) const {
    return std::visit([&](const auto& motion) { return motion.point(point)[0]; }, motion_);
  }

 private:
  using Motion = std::variant<MechanismMotion<0>, FollowedMotion<0>>;

  static Motion motion_of(const Mechanism<double>& mechanism) {
    if (!has_groups(mechanism)) return Motion(std::in_place_type<MechanismMotion<0>>, mechanism);
    return Motion(std::in_place_type<FollowedMotion<0>>, mechanism, follow(mechanism, 0, kTurn));
  }

  Motion motion_;
};

}  // namespace cognate::problems
