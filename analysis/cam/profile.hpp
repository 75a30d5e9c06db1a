/// @file The curves of a cam: pitch curve, profile, path of a cutter's centre.
#pragma once

#include <vector>

#include "analysis/cam/motion_programme.hpp"
#include "analysis/cam/quantity.hpp"

namespace cognate::cam {

/// A point of a curve, in the cam's own axes for a cam that turns counter-clockwise.
struct ProfilePoint {
  double angle = 0;  ///< of the cam, where its follower stands on this normal
  Vec2d at;
  Vec2d normal;          ///< unit, away from the material
  double curvature = 0;  ///< positive where the curve is convex
};

/// A curve parallel to that which the follower gives: the pitch curve for a roller, the profile for
/// a flat face. `distance` is along its outward normal: −roller radius is a roller's profile,
/// +roller radius the outer wall of its groove, cutter radius − roller radius the path of a
/// cutter's centre.
struct CamCurve {
  const CamSystem<double>& cam;
  const MotionProgramme& programme;
  double distance = 0;
};

/// The point of `curve` at the share `t` of piece `piece`.
ProfilePoint curve_point(const CamCurve& curve, int piece, double t);

/// Points of the whole curve, in order of the cam angle, the last before the first comes round:
/// whose polygon is nowhere farther than `chord_tolerance` from it. Where the curve has a corner (a
/// jump of velocity) both its sides are points, and about a corner that a roller rounds the arc is.
/// At most `most` points; then the tolerance is not kept.
std::vector<ProfilePoint> polygon(const CamCurve& curve, double chord_tolerance,
                                  std::size_t most = 2'000'000);

/// Whether a closed polygon crosses itself: the mark of undercutting, of any cause.
bool crosses_itself(const std::vector<ProfilePoint>& polygon);

}  // namespace cognate::cam
