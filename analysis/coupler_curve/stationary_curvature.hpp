/// @file The points of a body whose paths keep their curvature for a moment: the circling-point
/// curve, its centres, and Ball's point.
///
/// In axes with the origin at the pole, y along the pole normal towards the inflection pole and x
/// along the pole tangent, the points (r cos ψ, r sin ψ) with dκ/ds = 0 satisfy
///
///     1/r = 1/(M sin ψ) + 1/(N cos ψ),   or   (x² + y²)(x/M + y/N) = x y.
///
/// With δ the diameter of the inflection circle and x′, y′ the components of d²U/dφ²,
///
///     1/M = (2 δ + y′)/(3 δ²),   1/N = −x′/(3 δ²).
///
/// Hartenberg & Denavit, Kinematic Synthesis of Linkages, 1964, chapter 7; Bottema & Roth,
/// Theoretical Kinematics, 1979, chapter 8.
#pragma once

#include <optional>
#include <vector>

#include "analysis/coupler_curve/pole.hpp"

namespace cognate {

/// A cubic through the pole with a double point there. Where 1/M is zero it is the pole tangent and
/// a circle of diameter N that touches the pole normal; where 1/N is zero, the pole normal and a
/// circle of diameter M that touches the pole tangent; where both are, tangent and normal.
struct StationaryCubic {
  Vec2d pole;
  Vec2d axis{1, 0};      ///< unit vector of x
  double diameter = 0;   ///< δ > 0
  double inverse_m = 0;  ///< 1/M
  double inverse_n = 0;  ///< 1/N

  /// (x² + y²)(x/M + y/N) − x y at a point in global axes: zero on the curve.
  double value(const Vec2d& point) const;

  /// The point of the curve, other than the pole, on the ray through the pole in the unit
  /// `direction` (global axes), on either side. Empty where the ray meets the curve nowhere else:
  /// along the asymptote, and along a tangent or normal that belongs to the curve.
  std::optional<Vec2d> at(const Vec2d& direction) const;
};

/// The circling-point curve (cubic of stationary curvature). Empty where the pole stands still: all
/// paths then are circles about it, to this order.
std::optional<StationaryCubic> circling_points(const Pole& pole);

/// The centres of curvature of the paths of the circling points: the same with 1/M − 1/δ.
StationaryCubic centre_points(const StationaryCubic& circling);

/// `count` points of a cubic on rays from the pole, equally spaced over half a turn from the pole
/// tangent; rays without a point, and points farther from the pole than `reach`, are left out.
std::vector<Vec2d> sample(const StationaryCubic& cubic, int count, double reach);

/// Ball's point, whose path is straight to the third order: where the circling-point curve meets
/// the inflection circle off the pole, tan ψ = N (1/δ − 1/M). Empty where it falls on the pole (M =
/// δ), and where the whole inflection circle belongs to the curve (1/N = 0 as well).
std::optional<Vec2d> ball_point(const StationaryCubic& circling);

}  // namespace cognate
