/// @file Where a cam touches its follower: contact, pressure angle and curvature.
///
/// All is seen by the frame: the cam's centre is the origin, the cam turns counter-clockwise, a
/// translating follower moves along +y at x = offset, an oscillating one swings about
/// (0, centre_distance). The cam's own axes are those of the frame at cam angle 0. Derivatives are
/// by the cam angle in radians. Every function is a template on the number type: double, one with
/// derivatives by the dimensions, one with more digits.
///
/// Sources: Norton, Cam Design and Manufacturing Handbook; the pitch curve of the swinging roller
/// as in Li & Xu 2011, example 4-3.
#pragma once

#include <cmath>

#include "analysis/cam/follower.hpp"
#include "analysis/cam/motion_piece.hpp"
#include "analysis/numbers/vec2.hpp"

namespace cognate::cam {

/// Where the follower stands at displacement 0: the height of a translating roller's centre above
/// the cam's (s₀), of a flat face its distance; of an oscillating follower the angle between its
/// arm or face and the line from its pivot to the cam's centre. Nothing finite where the dimensions
/// cannot be put together (|offset| > base radius, no triangle).
template <class T>
T starting_place(const CamFollower<T>& follower) {
  using std::acos;
  using std::asin;
  using std::sqrt;
  const auto& d = follower.dimensions;
  switch (follower.type) {
    case FollowerType::translating_flat:
      return d.base_radius;
    case FollowerType::oscillating_roller:
    case FollowerType::oscillating_knife: {
      // By the half angle: acos of the cosine rule loses half its digits where the triangle is
      // flat.
      const T& a = d.centre_distance;
      const T& l = d.arm;
      const T up = d.base_radius * d.base_radius - (a - l) * (a - l);
      const T down = (a + l) * (a + l) - d.base_radius * d.base_radius;
      using std::atan2;
      return T(2) * atan2(sqrt(up), sqrt(down));
    }
    case FollowerType::oscillating_flat:
      return asin((d.base_radius + d.face_offset) / d.centre_distance);
    default:
      return sqrt((d.base_radius - d.offset) * (d.base_radius + d.offset));
  }
}

/// The centre of a roller (or the point of a knife edge), how it moves as seen from the cam, and
/// the direction in which the follower gives way.
template <class T>
struct RollerState {
  Vec2<T> centre;
  Vec2<T> tangent;  ///< of the pitch curve, its derivative by the cam angle
  Vec2<T> second;   ///< second derivative of the pitch curve, in the frame's axes
  T across{};       ///< tan of the pressure angle is across / along
  T along{};        ///< > 0
};

template <class T>
RollerState<T> translating_state(const CamDimensions<T>& d, const T& start,
                                 const FollowerMotion<T>& m) {
  const T y = start + m.displacement;
  const T across = m.velocity - d.offset;
  return {{d.offset, y}, {y, across}, {m.velocity + across, m.acceleration - y}, across, y};
}

template <class T>
RollerState<T> oscillating_state(const CamDimensions<T>& d, ArmSide side, const T& start,
                                 const FollowerMotion<T>& m) {
  using std::cos;
  using std::sin;
  const T sign(sign_of(side));
  const T angle = start + m.displacement;
  const T c = cos(angle), s = sin(angle);
  const Vec2<T> arm{-sign * d.arm * s, -d.arm * c};
  const Vec2<T> rise{-sign * d.arm * c, d.arm * s};  // derivative of `arm` by the angle
  const Vec2<T> centre{arm.x, d.centre_distance + arm.y};
  const Vec2<T> velocity = m.velocity * rise;
  const Vec2<T> acceleration = m.acceleration * rise - (m.velocity * m.velocity) * arm;
  const Vec2<T> tangent = velocity - perp(centre);
  return {centre, tangent, acceleration - T(2) * perp(velocity) - centre,
          d.arm * m.velocity - sign * (d.centre_distance * c - d.arm), d.centre_distance * s};
}

/// The state of a follower with a roller or a knife edge at motion `m`; `start` is its
/// `starting_place`.
template <class T>
RollerState<T> roller_state(const CamFollower<T>& follower, const T& start,
                            const FollowerMotion<T>& m) {
  return has_arm(follower.type) ? oscillating_state(follower.dimensions, follower.side, start, m)
                                : translating_state(follower.dimensions, start, m);
}

/// Curvature of the pitch curve, positive where it is convex.
template <class T>
T pitch_curvature(const RollerState<T>& state) {
  using std::sqrt;
  const T square = squared_norm(state.tangent);
  return -cross(state.tangent, state.second) / (square * sqrt(square));
}

/// Where a flat face touches the cam, and what follows.
template <class T>
struct FaceState {
  T reach{};  ///< of the contact along the face: from the follower's axis, or from the pivot's foot
  T radius{};  ///< of curvature of the profile; negative: undercut
  Vec2<T> contact;
  Vec2<T> normal;  ///< of the face, away from the cam
  T across{};      ///< tan of the pressure angle is across / along
  T along{};
};

template <class T>
FaceState<T> sliding_face(const T& start, const FollowerMotion<T>& m) {
  const T height = start + m.displacement;
  return {m.velocity, height + m.acceleration, {m.velocity, height}, {T(0), T(1)}, T(0), T(1)};
}

/// The face turns by 1 + sign·s′ for each radian of the cam as seen from it; this must be positive.
template <class T>
FaceState<T> swinging_face(const CamDimensions<T>& d, ArmSide side, const T& start,
                           const FollowerMotion<T>& m) {
  using std::cos;
  using std::sin;
  const T sign(sign_of(side));
  const T angle = start + m.displacement;
  const T c = cos(angle), s = sin(angle);
  const T turn = T(1) + sign * m.velocity;
  const T reach = d.centre_distance * c / turn;
  const Vec2<T> face{-sign * s, -c};
  const Vec2<T> normal{-sign * c, s};
  const Vec2<T> contact = Vec2<T>{T(0), d.centre_distance} + reach * face - d.face_offset * normal;
  // The support function h = a sin ψ − f of the normal's direction; the radius is h + h″.
  const T second = d.centre_distance * (c * m.acceleration - s * m.velocity * m.velocity * turn) /
                   (turn * turn * turn);
  return {
      reach, d.centre_distance * s - d.face_offset + second, contact, normal, -sign * d.face_offset,
      reach};
}

template <class T>
FaceState<T> face_state(const CamFollower<T>& follower, const T& start,
                        const FollowerMotion<T>& m) {
  return follower.type == FollowerType::oscillating_flat
             ? swinging_face(follower.dimensions, follower.side, start, m)
             : sliding_face(start, m);
}

/// `at`, of the frame, as the cam sees it at cam angle δ, given as a unit vector (cos δ, sin δ).
template <class T>
Vec2<T> in_cam(const Vec2<T>& at, const Vec2<T>& direction) {
  return at * conj(direction);
}

}  // namespace cognate::cam
