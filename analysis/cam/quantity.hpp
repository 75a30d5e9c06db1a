/// @file What can be asked of a cam at one position, as analytic functions of the cam angle.
#pragma once

#include <cmath>

#include "analysis/cam/contact.hpp"
#include "analysis/cam/operation.hpp"

namespace cognate::cam {

enum class CamQuantity {
  pressure_angle,   ///< rad; positive where the cam pushes along with its own surface's motion
  pitch_curvature,  ///< of the roller's centre's path, positive where convex
  face_radius,      ///< radius of curvature of a profile for a flat face
  reach,            ///< of the contact along a flat face
  squared_radius,   ///< of the profile, its distance from the cam's centre
  roller_speed,     ///< of the roller about its own axis, over the cam's speed
  demand,           ///< force (moment) along the motion that the cam must give the follower
  contact_force,    ///< along the normal; negative where the follower would lift off
  torque,           ///< that drives the cam
  squared_stress    ///< Hertzian pressure of line contact, squared
};

/// A cam with its follower, ready to be evaluated.
template <class T>
struct CamSystem {
  CamFollower<T> follower;
  T start{};  ///< `starting_place(follower)`
  Operation operation{};
  bool groove =
      false;  ///< the roller runs between two walls: where the force is negative, on the outer
};

/// Mass times acceleration, spring and load: what the cam must overcome along the motion. Negative
/// where the follower must be held back.
template <class T>
T demand(const Operation& o, const FollowerMotion<T>& m) {
  return T(o.inertia * o.speed * o.speed * o.displacement) * m.acceleration +
         T(o.spring_rate) * m.displacement + T(o.preload + o.load);
}

/// tan of the pressure angle as a quotient, across / along, of lengths (of numbers, for a sliding
/// face); `along` is positive wherever the follower can stand.
template <class T>
struct PressureParts {
  T across{};
  T along{};
};

template <class T>
PressureParts<T> pressure_parts(const CamSystem<T>& cam, const FollowerMotion<T>& m) {
  if (is_flat(cam.follower.type)) {
    const auto state = face_state(cam.follower, cam.start, m);
    return {state.across, state.along};
  }
  const auto state = roller_state(cam.follower, cam.start, m);
  return {state.across, state.along};
}

/// Force over demand: 1 / cos α, over the arm in metres where moments are demanded.
template <class T>
T force_ratio(const CamSystem<T>& cam, const T& across, const T& along) {
  using std::sqrt;
  const auto type = cam.follower.type;
  if (type == FollowerType::oscillating_flat) return T(1) / (T(cam.operation.metres) * along);
  const T ratio = sqrt(across * across + along * along) / along;
  if (!has_arm(type)) return ratio;
  return ratio / (T(cam.operation.metres) * cam.follower.dimensions.arm);
}

/// Speed of a roller about its axis as seen from the follower, over that of the cam: rolling
/// without sliding.
template <class T>
T roller_speed(const CamSystem<T>& cam, const RollerState<T>& state, const FollowerMotion<T>& m) {
  using std::sqrt;
  const T& radius = cam.follower.dimensions.roller_radius;
  const T length = sqrt(squared_norm(state.tangent));
  // The cam's surface passes the roller's centre with −tangent, less what the radius turns.
  // On the outer wall of a groove it passes the other side of the roller.
  const bool outside = cam.groove && demand(cam.operation, m) < T(0);
  const T spin = (outside ? radius + length : radius - length) / radius;
  const bool swings = has_arm(cam.follower.type);
  return swings ? spin + T(sign_of(cam.follower.side)) * m.velocity : spin;
}

/// Squared pressure of a line contact over force and relative curvature (Johnson, Contact
/// Mechanics, equation 4.45).
inline double hertz_factor(const Operation& o) {
  return 1 / (pi_of<double>() * o.width * o.modulus_sum);
}

template <class T>
T roller_quantity(CamQuantity quantity, const CamSystem<T>& cam, const FollowerMotion<T>& m) {
  using std::atan2;
  using std::sqrt;
  const auto state = roller_state(cam.follower, cam.start, m);
  const T& radius = cam.follower.dimensions.roller_radius;
  switch (quantity) {
    case CamQuantity::pressure_angle:
      return atan2(state.across, state.along);
    case CamQuantity::pitch_curvature:
      return pitch_curvature(state);
    case CamQuantity::squared_radius: {
      const T length = sqrt(squared_norm(state.tangent));
      return squared_norm(state.centre - (radius / length) * perp(state.tangent));
    }
    case CamQuantity::roller_speed:
      return roller_speed(cam, state, m);
    case CamQuantity::contact_force:
      return demand(cam.operation, m) * force_ratio(cam, state.across, state.along);
    case CamQuantity::squared_stress: {
      // κ/(1 − rκ) + 1/r = 1/(r (1 − rκ)); on the outer wall of a groove r changes its sign.
      const T force = demand(cam.operation, m) * force_ratio(cam, state.across, state.along);
      const T turn = radius * pitch_curvature(state);
      const bool outside = cam.groove && force < T(0);
      const T wall = outside ? T(-1) - turn : T(1) - turn;
      return T(hertz_factor(cam.operation)) * force / (radius * wall);
    }
    default:
      return T(0);
  }
}

template <class T>
T face_quantity(CamQuantity quantity, const CamSystem<T>& cam, const FollowerMotion<T>& m) {
  using std::atan2;
  const auto state = face_state(cam.follower, cam.start, m);
  switch (quantity) {
    case CamQuantity::pressure_angle:
      return atan2(state.across, state.along);
    case CamQuantity::face_radius:
      return state.radius;
    case CamQuantity::reach:
      return state.reach;
    case CamQuantity::squared_radius:
      return squared_norm(state.contact);
    case CamQuantity::contact_force:
      return demand(cam.operation, m) * force_ratio(cam, state.across, state.along);
    case CamQuantity::squared_stress: {
      const T force = demand(cam.operation, m) * force_ratio(cam, state.across, state.along);
      return T(hertz_factor(cam.operation)) * force / state.radius;
    }
    default:
      return T(0);
  }
}

/// `quantity` of `cam` where its follower's motion is `m`. What a follower does not have (the reach
/// of a roller, the pitch curvature of a flat face) is 0.
template <class T>
T value_of(CamQuantity quantity, const CamSystem<T>& cam, const FollowerMotion<T>& m) {
  if (quantity == CamQuantity::demand) return demand(cam.operation, m);
  if (quantity == CamQuantity::torque) {
    return demand(cam.operation, m) * (T(cam.operation.displacement) * m.velocity);
  }
  return is_flat(cam.follower.type) ? face_quantity(quantity, cam, m)
                                    : roller_quantity(quantity, cam, m);
}

}  // namespace cognate::cam
