/// @file A mechanism moved along the assembly ranges of its motion.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "analysis/mechanism/assembly_ranges.hpp"
#include "analysis/mechanism/kinematics.hpp"

namespace cognate {

/// Moves `motion` to `drive`, its groups as a motion from where they are drawn leads there.
template <int Order>
bool move_followed(MechanismMotion<Order>& motion, double drive) {
  if (has_groups(motion.mechanism())) {
    const AssemblyRanges ranges = follow(motion.mechanism(), drive, drive);
    const AssemblyRange* run = ranges.range_at(drive);
    if (run == nullptr) return false;
    place_groups(*run, drive, motion.places());
  }
  return motion.move_to(drive);
}

/// A mechanism with room for its state, moved along assembly ranges: with the signs of the
/// assemblies that the motion has there, and across change points. On a change point itself the
/// closure is singular and the motion is not; there all is interpolated from six positions about
/// it, which leaves positions to rounding and loses some 2, 5 and 8 digits of the derivatives.
template <int Order>
class FollowedMotion {
 public:
  /// To be moved along `assembly_ranges`, which is one of `mechanism`.
  FollowedMotion(const Mechanism<double>& mechanism, AssemblyRanges assembly_ranges)
      : motion_(mechanism),
        assembly_ranges_(std::move(assembly_ranges)),
        bodies_(motion_.bodies().size()),
        closures_(motion_.closures().size()) {}

  /// Moves to a drive coordinate of the assembly ranges; false, and bodies that are not
  /// numbers, where the mechanism cannot be assembled or its position is not determined.
  bool move_to(double drive) {
    const AssemblyRange* run = assembly_ranges_.range_at(drive);
    if (run == nullptr) {
      leave();
      return false;
    }
    const Change* change = near(*run, drive);
    at_change_ = change != nullptr;
    const bool found =
        at_change_ ? change->determined && interpolate(*run, *change, drive) : place(*run, drive);
    if (!found) leave();
    return found;
  }

  /// At a dead point rates by the drive are infinite, and what is computed of them is rounding.
  /// Makes those of the dyad that stands there and of all bodies after it not numbers; true where
  /// there is one. To be called after `move_to` has found a position.
  bool drop_infinite_rates() {
    if (at_change_) return false;
    const auto is_dead = [](const DyadClosure<double>& closure) {
      return closure.sine * closure.sine <= 16 * std::numeric_limits<double>::epsilon();
    };
    const auto dead = std::ranges::find_if(closures_, is_dead);
    if (dead == closures_.end()) return false;
    const auto dyad = static_cast<int>(dead - closures_.begin());
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    for (auto body = bodies_.begin() + first_body(mechanism(), dyad); body != bodies_.end();
         ++body) {
      std::fill(body->origin.begin() + 1, body->origin.end(), Vec2d{kNone, kNone});
      body->turn.fill(kNone);
    }
    return true;
  }

  /// What is followed, and where bodies and dyads stand after `move_to`.
  const AssemblyRanges& assembly_ranges() const { return assembly_ranges_; }
  const Mechanism<double>& mechanism() const { return motion_.mechanism(); }
  std::span<const BodyMotion<double, Order>> bodies() const { return bodies_; }
  std::span<const DyadClosure<double>> closures() const { return closures_; }

  /// dᵏ/dqᵏ of an attached point.
  std::array<Vec2d, Order + 1> point(const Attached<double>& point) const {
    return point_motion(bodies_[static_cast<std::size_t>(point.body)], point.at);
  }

 private:
  /// Within this part of the drive's scale of a change, positions are interpolated.
  static constexpr double kNear = 1e-6;
  static constexpr double kStep = 5e-3;

  const Change* near(const AssemblyRange& run, double drive) const {
    for (const Change& change : run.changes) {
      if (std::abs(change.drive - drive) <= kNear * assembly_ranges_.scale) return &change;
    }
    return nullptr;
  }

  /// Moves the mechanism to `drive` with the assemblies that it has there.
  bool assemble(const AssemblyRange& run, double drive) {
    sides_or_none_at(run, drive, motion_.sides());
    place_groups(run, drive, motion_.places());
    return motion_.move_to(drive);
  }

  /// Takes the state at `drive`.
  bool place(const AssemblyRange& run, double drive) {
    if (!assemble(run, drive)) return false;
    std::ranges::copy(motion_.bodies(), bodies_.begin());
    std::ranges::copy(motion_.closures(), closures_.begin());
    return true;
  }

  /// Adds `weight` times the state at `drive` to what is there.
  bool add(const AssemblyRange& run, double drive, double weight) {
    if (!assemble(run, drive)) return false;
    for (std::size_t i = 0; i < bodies_.size(); ++i) add(motion_.bodies()[i], weight, bodies_[i]);
    for (std::size_t i = 0; i < closures_.size(); ++i) {
      const DyadClosure<double>& from = motion_.closures()[i];
      closures_[i].discriminant += weight * from.discriminant;
      closures_[i].sine += weight * from.sine;
      closures_[i].cosine += weight * from.cosine;
    }
    return true;
  }

  static void add(const BodyMotion<double, Order>& from, double weight,
                  BodyMotion<double, Order>& to) {
    to.direction = to.direction + weight * from.direction;
    for (std::size_t k = 0; k < to.origin.size(); ++k) {
      to.origin[k] = to.origin[k] + weight * from.origin[k];
    }
    for (std::size_t k = 0; k < to.turn.size(); ++k) to.turn[k] += weight * from.turn[k];
  }

  /// The step of the interpolation about `change`, less where something else is close.
  double step(const AssemblyRange& run, const Change& change) const {
    double room = 12 * kStep * assembly_ranges_.scale;
    if (run.from_dyad >= 0) room = std::min(room, change.drive - run.from);
    if (run.to_dyad >= 0) room = std::min(room, run.to - change.drive);
    for (const Change& other : run.changes) {
      const double distance = std::abs(other.drive - change.drive);
      if (distance > 0) room = std::min(room, distance);
    }
    return room / 12;
  }

  /// Lagrange's polynomial through the states at ±1, ±2 and ±3 steps from the change.
  bool interpolate(const AssemblyRange& run, const Change& change, double drive) {
    constexpr std::array<double, 6> kNodes{-3, -2, -1, 1, 2, 3};
    const double h = step(run, change);
    const double x = (drive - change.drive) / h;
    std::ranges::fill(bodies_, zero());
    std::ranges::fill(closures_, DyadClosure<double>{});
    for (const double node : kNodes) {
      double weight = 1;
      for (const double other : kNodes) {
        if (other != node) weight *= (x - other) / (node - other);
      }
      if (!add(run, change.drive + node * h, weight)) return false;
    }
    for (BodyMotion<double, Order>& body : bodies_) {
      body.direction = (1 / std::sqrt(squared_norm(body.direction))) * body.direction;
    }
    return true;
  }

  static BodyMotion<double, Order> zero() {
    BodyMotion<double, Order> body;
    body.direction = {0, 0};
    return body;
  }

  void leave() {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    BodyMotion<double, Order> nowhere;
    nowhere.direction = {kNone, kNone};
    nowhere.origin.fill({kNone, kNone});
    nowhere.turn.fill(kNone);
    std::fill(bodies_.begin() + 1, bodies_.end(), nowhere);
    std::ranges::fill(closures_, DyadClosure<double>{kNone, kNone, kNone});
  }

  MechanismMotion<Order> motion_;
  AssemblyRanges assembly_ranges_;
  std::vector<BodyMotion<double, Order>> bodies_;
  std::vector<DyadClosure<double>> closures_;
  bool at_change_ = false;
};

}  // namespace cognate
