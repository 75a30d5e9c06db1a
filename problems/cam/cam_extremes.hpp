/// @file The extremes of a cam that facts and checks speak of.
#pragma once

#include <optional>

#include "analysis/cam/cam.hpp"
#include "analysis/cam/turn_extremes.hpp"
#include "problems/cam/cam_problem.hpp"

namespace cognate::problems {

/// A greatest or least value and the cam angle where it is, rad.
struct FoundAt {
  double value = 0;
  double angle = 0;
};

/// The greatest pressure angle of either sign.
FoundAt greatest_pressure_angle(const cam::Cam& cam);

/// The greatest over the rises, on the side to which the cam pushes in them; over the returns, on
/// the other. Nothing where the motion has none.
std::optional<FoundAt> pressure_angle_of(const cam::Cam& cam, cam::Stretch stretch);

/// Radii of curvature of the profile: the least where it is convex (negative: undercut, the profile
/// would turn back on itself), and where it is concave. Nothing where it is nowhere so.
std::optional<FoundAt> least_convex_radius(const cam::Cam& cam);
std::optional<FoundAt> least_concave_radius(const cam::Cam& cam);

/// Least and greatest distance of the profile from the cam's centre.
FoundAt least_profile_radius(const cam::Cam& cam);
FoundAt greatest_profile_radius(const cam::Cam& cam);

/// The width of the part of a flat face that the cam touches.
double face_width(const cam::Cam& cam);

/// The greatest contact force; `both_ways`, of a form-closed follower, the one of greatest size.
FoundAt greatest_force(const cam::Cam& cam, bool both_ways);

/// The least demand, the torque of greatest size, the greatest stress, the roller's greatest speed.
FoundAt least_demand(const cam::Cam& cam);
FoundAt greatest_torque(const cam::Cam& cam);
FoundAt greatest_stress(const cam::Cam& cam);
FoundAt greatest_roller_speed(const cam::Cam& cam);

}  // namespace cognate::problems
