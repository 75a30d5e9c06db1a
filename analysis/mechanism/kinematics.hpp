/// @file Evaluating a mechanism: all bodies at one position of the drive.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <type_traits>
#include <variant>
#include <vector>

#include "analysis/mechanism/cylinder_motion.hpp"
#include "analysis/mechanism/dyad_motion.hpp"
#include "analysis/mechanism/group_closure.hpp"
#include "analysis/mechanism/mechanism.hpp"
#include "analysis/mechanism/motion_state.hpp"
#include "analysis/mechanism/motion_terms.hpp"
#include "analysis/mechanism/rrr_motion.hpp"

namespace cognate {

/// Fills the one body of a crank.
template <int Order, class T>
void place_drive(const Crank<T>& crank, const DrivePosition<T>& drive,
                 std::span<BodyMotion<T, Order>> bodies) {
  BodyMotion<T, Order> body;
  body.direction = drive.direction;
  body.origin[0] = crank.pivot;
  if constexpr (Order >= 1) body.turn[0] = T(1);
  bodies[0] = body;
}

/// Fills the one body of a driving slider.
template <int Order, class T>
void place_drive(const DrivingSlider<T>& slider, const DrivePosition<T>& drive,
                 std::span<BodyMotion<T, Order>> bodies) {
  const Guide<T>& guide = slider.guide;
  BodyMotion<T, Order> body;
  body.direction = guide.direction;
  body.origin[0] = guide.through + Vec2<T>{drive.displacement, guide.offset} * guide.direction;
  if constexpr (Order >= 1) body.origin[1] = guide.direction;
  bodies[0] = body;
}

/// Fills the link and its two blocks. With e the link's direction and d₁, d₂ those of the guides,
/// which the link leaves at s₁ and s₂: s₁d₁ − s₂d₂ = G₂ − G₁ − l e, so that s₁ = (G₂ − G₁ − l e) ×
/// d₂/(d₁ × d₂). Not numbers where the guides are parallel.
template <int Order, class T>
void place_drive(const FloatingLink<T>& link, const DrivePosition<T>& drive,
                 std::span<BodyMotion<T, Order>> bodies) {
  const Guide<T>&first = link.first, &second = link.second;
  BodyMotion<T, Order> body, first_block, second_block;
  body.direction = drive.direction;
  first_block.direction = first.direction;
  second_block.direction = second.direction;

  const T inverse = T(1) / cross(first.direction, second.direction);
  const Vec2<T> foot = first.through + first.offset * perp(first.direction);
  // (G₂ − G₁) × d₂ takes the second guide's offset as it is: perp(d₂) × d₂ = −1.
  const Vec2<T> arm = link.length * drive.direction;
  const T slide = inverse * (cross(second.through - foot - arm, second.direction) - second.offset);
  body.origin[0] = foot + slide * first.direction;
  second_block.origin[0] = body.origin[0] + arm;

  if constexpr (Order >= 1) body.turn[0] = T(1);
  motion_terms::for_each_order<Order>([&](auto order) {
    constexpr int kOrder = order();
    const Vec2<T> arm_rate = motion_terms::turned<kOrder>(body, arm);
    body.origin[kOrder] = (-inverse * cross(arm_rate, second.direction)) * first.direction;
    second_block.origin[kOrder] = body.origin[kOrder] + arm_rate;
  });
  first_block.origin = body.origin;
  bodies[0] = body;
  bodies[1] = first_block;
  bodies[2] = second_block;
}

/// The rod is placed with its cylinder.
template <int Order, class T>
void place_drive(const DrivingRod<T>&, const DrivePosition<T>&,
                 std::span<BodyMotion<T, Order>> bodies) {
  bodies[0] = BodyMotion<T, Order>{};
}

/// +1 or −1 for each dyad, as its `assembly` says (+1 where it has none).
std::vector<double> sides(const Mechanism<double>& mechanism);

/// The drive at `coordinate`: an angle from the x axis in radians, a driving slider's displacement
/// or a cylinder's length.
DrivePosition<double> drive_position(const Mechanism<double>& mechanism, double coordinate);

/// Fills `bodies` (body_count(mechanism) of them, the frame at 0) with their motion at `drive`,
/// derivatives up to `Order` ≤ 3, and `closures` (one for each dyad). `sides` are the signs of the
/// dyads' assemblies; a motion that is followed through a change point flips them. Where a dyad
/// cannot be assembled, its bodies and all that depend on them are not numbers; at a dead point
/// derivatives are infinite or not numbers. Allocates nothing, and neither branches on values of T
/// nor uses trigonometry. Lengths are 0 or from 1e-100 to 1e100.
///
/// Of a group `bodies` hold where its bodies stand at a position nearby, from which it is closed
/// (analysis/mechanism/group_closure.hpp); over Dual that takes an array of the bodies before, over
/// number types other than double and Dual they are not numbers.
template <int Order, class T>
void evaluate(const Mechanism<T>& mechanism, const DrivePosition<std::type_identity_t<T>>& drive,
              std::span<const std::type_identity_t<T>> sides,
              std::span<BodyMotion<std::type_identity_t<T>, Order>> bodies,
              std::span<DyadClosure<std::type_identity_t<T>>> closures) {
  static_assert(0 <= Order && Order <= 3);
  bodies[0] = BodyMotion<T, Order>{};
  std::visit([&](const auto& member) { place_drive<Order, T>(member, drive, bodies.subspan(1)); },
             mechanism.drive);
  const bool is_crank = std::holds_alternative<Crank<T>>(mechanism.drive);
  auto next = static_cast<std::size_t>(first_body(mechanism, 0));
  for (std::size_t i = 0; i < mechanism.dyads.size(); ++i, next += 2) {
    const BodiesBefore<T, Order> before = bodies.first(next);
    const auto take = [&](const DyadMotion<T, Order>& dyad) {
      bodies[next] = dyad.first;
      bodies[next + 1] = dyad.second;
      closures[i] = dyad.closure;
    };
    std::visit(
        [&]<class Closing>(const Closing& group) {
          if constexpr (std::is_same_v<Closing, Group>) {
            closures[i] = close_group<Order, T>(group, next, sides[i], bodies);
          } else if constexpr (std::is_same_v<Closing, GroupRest>) {
            closures[i] = closures[i - 1];
          } else if constexpr (std::is_same_v<Closing, Cylinder<T>>) {
            take(close_cylinder<Order, T>(group, drive.displacement, sides[i], before, bodies[1]));
          } else {
            if constexpr (std::is_same_v<Closing, Rrr<T>>) {
              const bool on_crank = is_crank && group.first.body + group.second.body == 1;
              if (on_crank) return take(close_on_crank<Order, T>(group, sides[i], before));
            }
            take(close_dyad<Order, T>(group, sides[i], before));
          }
        },
        mechanism.dyads[i]);
  }
}

/// A mechanism with room for its state: bodies and closures as `evaluate` fills them.
template <int Order>
class MechanismMotion {
 public:
  /// Stands nowhere until `move_to`.
  explicit MechanismMotion(const Mechanism<double>& mechanism)
      : mechanism_(mechanism),
        sides_(cognate::sides(mechanism)),
        bodies_(static_cast<std::size_t>(body_count(mechanism))),
        closures_(mechanism.dyads.size()) {
    for (std::size_t i = 0; i < mechanism.dyads.size(); ++i) {
      const auto* group = std::get_if<Group>(&mechanism.dyads[i]);
      const auto first = static_cast<std::size_t>(first_body(mechanism, static_cast<int>(i)));
      if (group) place_drawn(*group, std::span(bodies_).subspan(first));
    }
  }

  /// Moves to a drive coordinate (radians or length); whether every body has a place there.
  /// Derivatives may still be infinite or not numbers, at a dead point.
  bool move_to(double coordinate) { return move_to(drive_position(mechanism_, coordinate)); }
  bool move_to(const DrivePosition<double>& drive) {
    evaluate<Order>(mechanism_, drive, sides_, bodies_, closures_);
    return std::ranges::all_of(bodies_, [](const BodyMotion<double, Order>& body) {
      return std::isfinite(body.direction.x) && std::isfinite(body.origin[0].x) &&
             std::isfinite(body.origin[0].y);
    });
  }

  /// What is moved, and where bodies and dyads stand after `move_to`.
  const Mechanism<double>& mechanism() const { return mechanism_; }
  std::span<const BodyMotion<double, Order>> bodies() const { return bodies_; }
  std::span<const DyadClosure<double>> closures() const { return closures_; }

  /// dᵏ/dqᵏ of an attached point.
  std::array<Vec2d, Order + 1> point(const Attached<double>& point) const {
    return point_motion(bodies_[static_cast<std::size_t>(point.body)], point.at);
  }

  /// Where groups are closed from at the next move: they stand where they stood last, at first
  /// where they are drawn.
  std::span<BodyMotion<double, Order>> places() { return bodies_; }

  /// The signs of the assemblies; flip one to go on through a change point.
  std::span<double> sides() { return sides_; }
  std::span<const double> sides() const { return sides_; }

 private:
  Mechanism<double> mechanism_;
  std::vector<double> sides_;
  std::vector<BodyMotion<double, Order>> bodies_;
  std::vector<DyadClosure<double>> closures_;
};

}  // namespace cognate
