/// @file The pole of a moving body, and the centrodes that it traces.
///
/// A body that turns is, for a moment, turning about its pole. With the body's angle φ as the
/// parameter, O its origin, and ′ the derivative by φ,
///
///     U = O + i O′,   P′ = i (P − U) for every point P of the body,
///
/// and the pole itself moves at U′, the common tangent of the fixed centrode, its path in the
/// plane, and the moving centrode, its path in the body. The one rolls on the other without
/// slipping. Bottema & Roth, Theoretical Kinematics, 1979, chapter 8.
#pragma once

#include <optional>

#include "analysis/mechanism/motion_state.hpp"
#include "analysis/numbers/vec2.hpp"

namespace cognate {

/// What a body is doing: turning about a pole; sliding, all its points with one velocity (the pole
/// is at infinity); or standing still, as a follower does at its limit position.
enum class InstantMotion { rotation, translation, rest };

/// Turning and velocity that rounding explains count as none: |φ′| ≤ 16 ε/h and |O′| ≤ 16 ε h |O″|
/// by the drive, where the motion changes over a change `h` of the drive: 1 for an angle, a length
/// of the mechanism for a driving slider.
InstantMotion instant_motion(const BodyMotion<double, 3>& body, double h = 1);

/// The pole in global axes with its derivatives by the body's angle φ, and φ by the drive q.
struct Pole {
  Vec2d at;
  Vec2d rate;       ///< dU/dφ: its length is the diameter δ of the inflection circle
  Vec2d second;     ///< d²U/dφ²
  double turn = 0;  ///< dφ/dq
  double spin = 0;  ///< d²φ/dq² / (dφ/dq)²
};

/// Empty unless the body is in rotation (`h` as in `instant_motion`).
std::optional<Pole> pole(const BodyMotion<double, 3>& body, double h = 1);

/// dU/dq, the pole velocity for a drive of unit speed.
Vec2d pole_velocity(const Pole& pole);

/// A centrode where the pole is: the point, the unit tangent in the direction in which the pole
/// moves as φ grows, and the curvature, positive to the left of that. Without tangent and curvature
/// where the pole stands still, as a fixed pivot does.
struct Centrode {
  Vec2d at;
  std::optional<Vec2d> tangent;
  std::optional<double> curvature;
};

/// In global axes.
Centrode fixed_centrode(const Pole& pole);

/// In the body's axes.
Centrode moving_centrode(const BodyMotion<double, 3>& body, const Pole& pole);

}  // namespace cognate
