/// @file The bodies of the drive: crank, driving slider, floating link.
#pragma once

#include <span>

#include "analysis/mechanism/motion_terms.hpp"

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

}  // namespace cognate
