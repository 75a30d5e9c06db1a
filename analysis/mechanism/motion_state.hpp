/// @file Where the bodies of a mechanism stand, and how they move with the drive.
///
/// Derivatives are taken with respect to the drive coordinate q (the crank's angle, the slider's
/// displacement), not time: they are pure geometry (Hall's kinematic coefficients). With
/// q̇ and q̈ of the drive: velocity = r′·q̇, acceleration = r″·q̇² + r′·q̈.
#pragma once

#include <array>

#include "analysis/numbers/vec2.hpp"

namespace cognate {

/// A body's axes, with derivatives up to `Order`: 0 positions alone, 1 velocities, 2
/// accelerations, 3 the third derivative.
template <class T, int Order>
struct BodyMotion {
  Vec2<T> direction{T(1), T(0)};                 ///< unit vector of the first axis
  std::array<Vec2<T>, Order + 1> origin{};       ///< dᵏ(origin)/dqᵏ
  std::array<T, Order == 0 ? 1 : Order> turn{};  ///< turn[k − 1] = dᵏφ/dqᵏ; unused for order 0
};

/// How well a dyad is closed: `discriminant` is negative (and the state not a number) where it
/// cannot be assembled; `sine` and `cosine` are those of its transmission angle, `sine` carrying
/// the sign of the assembly and vanishing at a dead point. The discriminant is sine², computed
/// without the root, and for RPR s² (a length squared):
///
///     RRR  the angle between the links at the inner joint
///     RRP  90° − pressure angle of the slider
///     RPR  (s, offset)/|block − pivot|
///     PRP  the angle from the first guide to the second
///     RPP  the angle from the guide to the slot
template <class T>
struct DyadClosure {
  T discriminant{};
  T sine{};
  T cosine{};
};

/// What drives: the crank's (or floating link's) direction, or the slider's displacement.
template <class T>
struct DrivePosition {
  Vec2<T> direction{T(1), T(0)};
  T displacement{};
};

/// dᵏ/dqᵏ, k = 0…Order, of the point `at` (in the body's axes) of `body`.
template <class T, int Order>
std::array<Vec2<T>, Order + 1> point_motion(const BodyMotion<T, Order>& body, const Vec2<T>& at) {
  const Vec2<T> r = body.direction * at;
  std::array<Vec2<T>, Order + 1> motion = body.origin;
  motion[0] = motion[0] + r;
  if constexpr (Order >= 1) motion[1] = motion[1] + body.turn[0] * perp(r);
  if constexpr (Order >= 2) {
    motion[2] = motion[2] + body.turn[1] * perp(r) - (body.turn[0] * body.turn[0]) * r;
  }
  if constexpr (Order >= 3) {
    const T cubed = body.turn[0] * body.turn[0] * body.turn[0];
    motion[3] =
        motion[3] + (body.turn[2] - cubed) * perp(r) - (T(3) * body.turn[0] * body.turn[1]) * r;
  }
  return motion;
}

}  // namespace cognate
