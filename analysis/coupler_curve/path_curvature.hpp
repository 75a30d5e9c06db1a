/// @file How the paths of a moving body's points curve: at one point, and over the whole plane.
///
/// With z = P − U from the pole, u = dU/dφ and δ = |u|, the point P moves along i z and the centre
/// of curvature C of its path satisfies Euler–Savary's relation
///
///     C − U = z (z × u)/(z × u − |z|²),   or   (1/r − 1/c) sin ψ = 1/δ
///
/// for the distances r and c of P and C from the pole and the angle ψ of their ray from the pole
/// tangent. Hartenberg & Denavit, Kinematic Synthesis of Linkages, 1964, chapter 7.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "analysis/coupler_curve/pole.hpp"
#include "analysis/mechanism/motion_state.hpp"
#include "analysis/numbers/circle.hpp"

namespace cognate {

/// The curvature of the path of a point with the derivatives `motion` (by any parameter, as
/// `point_motion` gives, two at least), positive to the left of its motion: v × a/|v|³. Empty where
/// the point stands still.
std::optional<double> curvature(std::span<const Vec2d> motion);

/// The derivative of the curvature by the length of the path. Empty where the point stands still.
std::optional<double> curvature_rate(const std::array<Vec2d, 4>& motion);

/// The centre of curvature. Empty at an inflection and where the point stands still.
std::optional<Vec2d> centre_of_curvature(const std::array<Vec2d, 4>& motion);

/// The points whose paths have no curvature now: the circle of diameter δ that touches the pole
/// tangent at the pole. Its farthest point from there, U − i u, is the inflection pole. Of radius
/// zero where the pole stands still.
Circle inflection_circle(const Pole& pole);
Vec2d inflection_pole(const Pole& pole);

/// The centres of curvature of the paths of points at infinity, and of those that straight lines of
/// the body envelop in their cusps: the mirror image of the inflection circle in the pole tangent
/// (la Hire's return circle).
Circle return_circle(const Pole& pole);

/// The points without tangential acceleration, Bresse's second circle (the inflection circle, of
/// those without normal acceleration, is the first): through the pole, its centre on the pole
/// tangent, of diameter δ/|spin|. `spin` is α/ω² of the body: Pole::spin for a drive of constant
/// speed. Empty at spin zero, where it is the pole normal.
std::optional<Circle> tangential_circle(const Pole& pole, double spin);

/// The point without acceleration, where Bresse's circles meet again, for α/ω² = `spin`.
Vec2d acceleration_pole(const Pole& pole, double spin);

/// The centre of curvature of the path of `point`, by Euler and Savary. Empty for points of the
/// inflection circle and for the pole.
std::optional<Vec2d> conjugate_centre(const Pole& pole, const Vec2d& point);

/// The point whose path has its centre of curvature at `centre`. Empty for points of the return
/// circle and for the pole.
std::optional<Vec2d> conjugate_point(const Pole& pole, const Vec2d& centre);

/// A straight line, by a point and a unit vector.
struct Line {
  Vec2d through;
  Vec2d direction;
};

/// What becomes of the inflection circle while a body slides: the points that move straight, on a
/// line across the motion. Empty in rotation and at rest, and where the body slides without angular
/// acceleration (|φ″| ≤ 16 ε/h²), so that all its points move alike. `h` as in `instant_motion`.
std::optional<Line> inflection_line(const BodyMotion<double, 3>& body, double h = 1);

}  // namespace cognate
