/// @file Constraints of a cam problem as functions of the position that must not be negative.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "analysis/cam/quantity.hpp"
#include "analysis/cam/turn_extremes.hpp"
#include "problems/cam/problem.hpp"

namespace cognate::problems {

enum class CamLimitKind {
  pressure,        ///< sign · pressure angle ≤ bound
  convex_radius,   ///< of the profile, at least the bound where it is convex
  concave_radius,  ///< of the profile, at least the bound where it is concave
  outer_wall,      ///< of a groove, where it is convex towards the roller
  face_radius,     ///< of a profile for a flat face, at least the bound
  profile_min,     ///< the profile's distance from the cam's centre
  profile_max,
  force,       ///< contact force at most the bound
  separation,  ///< contact force not negative
  torque,      ///< sign · torque ≤ bound
  stress,
  assembly  ///< the follower stands on its own side of the cam's centre
};

/// One constraint at every position of a stretch of the turn.
struct CamLimit {
  CamLimitKind kind = CamLimitKind::pressure;
  cam::MotionPart stretch = cam::MotionPart::whole;
  double bound = 0;
  double sign = 1;
};

/// Every constraint of `problem` that is one of positions and depends on what is free.
std::vector<CamLimit> cam_limits(const CamProblem& problem);

/// Of a limit of the contact stress, on the outer wall of a groove where its sign is −1. The stress
/// itself goes to infinity where the profile comes to a point; this does not.
template <class T>
T stress_margin(const CamLimit& limit, const cam::CamSystem<T>& system,
                const cam::FollowerMotion<T>& motion, double unit) {
  const double factor = hertz_factor(system.operation) / (limit.bound * limit.bound);
  const T force = value_of(cam::CamQuantity::contact_force, system, motion);
  if (is_flat(system.follower.type)) {
    return (value_of(cam::CamQuantity::face_radius, system, motion) - T(factor) * force) *
           T(1 / unit);
  }
  const T& radius = system.follower.dimensions.roller_radius;
  const T curvature = value_of(cam::CamQuantity::pitch_curvature, system, motion);
  return T(1) - T(limit.sign) * (radius * curvature + T(factor) * force / radius);
}

/// By how much `limit` is kept, of order 1: ≥ 0 where it is. Lengths count in `unit`. Smooth in all
/// that it depends on, wherever the follower can stand.
template <class T>
T margin(const CamLimit& limit, const cam::CamSystem<T>& system,
         const cam::FollowerMotion<T>& motion, double unit) {
  using cam::CamQuantity;
  const auto value = [&](CamQuantity quantity) { return value_of(quantity, system, motion); };
  switch (limit.kind) {
    case CamLimitKind::pressure: {
      const double tangent = std::tan(limit.bound);
      const auto [across, along] = pressure_parts(system, motion);
      return (T(tangent) * along - T(limit.sign) * across) *
             T(1 / (unit * std::hypot(1.0, tangent)));
    }
    case CamLimitKind::convex_radius:
      return T(1) - value(CamQuantity::pitch_curvature) *
                        (system.follower.dimensions.roller_radius + T(limit.bound));
    case CamLimitKind::concave_radius: {
      const T beyond = T(limit.bound) - system.follower.dimensions.roller_radius;
      if (!(beyond > T(0))) return T(1);
      return T(1) + value(CamQuantity::pitch_curvature) * beyond;
    }
    case CamLimitKind::outer_wall:
      return T(1) + value(CamQuantity::pitch_curvature) *
                        (system.follower.dimensions.roller_radius + T(limit.bound));
    case CamLimitKind::face_radius:
      return (value(CamQuantity::face_radius) - T(limit.bound)) * T(1 / unit);
    case CamLimitKind::profile_min:
      return (value(CamQuantity::squared_radius) - T(limit.bound * limit.bound)) *
             T(1 / (unit * unit));
    case CamLimitKind::profile_max:
      return T(1) - value(CamQuantity::squared_radius) * T(1 / (limit.bound * limit.bound));
    case CamLimitKind::force:
      return T(1) - T(limit.sign) * value(CamQuantity::contact_force) * T(1 / limit.bound);
    case CamLimitKind::separation:
      return value(CamQuantity::demand) * T(1 / limit.bound);
    case CamLimitKind::torque:
      return T(1) - T(limit.sign) * value(CamQuantity::torque) * T(1 / limit.bound);
    case CamLimitKind::stress:
      return stress_margin(limit, system, motion, unit);
    case CamLimitKind::assembly:
      return pressure_parts(system, motion).along * T(1 / unit) - T(1e-6);
  }
  return T(0);
}

}  // namespace cognate::problems
