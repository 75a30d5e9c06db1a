/// @file How closely the paths of a body's points touch their tangents.
///
/// With P₁, P₂, … the coefficients of a point's path, P has contact of k points with its tangent
/// where P₁ × P₂ = … = P₁ × P₍ₖ₋₁₎ = 0. Over the body each of these is a circle,
///
///     P₁ × Pₖ = a |z|² + l · z + c = 0,
///
/// which is kept in this form: a falls to zero as the body's angular velocity does, and the
/// inflection circle (k = 2) passes smoothly into the straight line that it is while the pole is at
/// infinity. Two of the circles, k = 2 and 3, meet in the pole and in Ball's point, which is found
/// from their common chord by the product of its distances, as a point of the projective plane.
///
/// Everything is counted from the crank pin B, in the directions of the series, and in its unit.
#pragma once

#include <array>
#include <cmath>
#include <optional>

#include "analysis/coupler_curve/coupler_series.hpp"
#include "analysis/coupler_curve/path_curvature.hpp"
#include "analysis/numbers/circle.hpp"
#include "analysis/numbers/vec2.hpp"

namespace cognate {

/// The order to which contact is determined: one less than the coefficients that a series has.
inline constexpr int kContactOrder = 8;
/// The coupler's motion about a position, to that order.
using ContactSeries = CouplerSeries<double, kContactOrder>;

/// square |z|² + linear · z + constant = 0: a circle, or a straight line where `square` is zero.
struct CircleOrLine {
  double square = 0;
  Vec2d linear;
  double constant = 0;
};

/// The left side of the equation at z.
double value(const CircleOrLine& locus, const Vec2d& z);

/// As a circle; empty for a line, and where its centre is farther off than `reach`.
std::optional<Circle> as_circle(const CircleOrLine& locus, double reach);

/// As a straight line through the foot of the perpendicular from B, where it is one to rounding for
/// a body of the size `size`: |square| size ≤ 64 ε |linear|. Empty otherwise.
std::optional<Line> as_line(const CircleOrLine& locus, double size);

/// The points of a line through `from` in the unit `direction` on the locus, as distances from
/// there, in order: none, one or two. Points that rounding does not keep apart count once.
std::array<std::optional<double>, 2> meet(const CircleOrLine& locus, const Vec2d& from,
                                          const Vec2d& direction);

/// Where P₁ × Pₖ vanishes, 2 ≤ k ≤ kContactOrder: the inflection circle for k = 2.
CircleOrLine contact_locus(const ContactSeries& series, int k);

/// The coefficients of the path of z: the point itself (k = 0, from the crank pivot) and what
/// follows.
std::array<Vec2d, kContactOrder + 1> path_series(const ContactSeries& series, const Vec2d& z);

/// The line through the points that two loci share, as a locus whose `square` is zero.
CircleOrLine common_chord(const CircleOrLine& a, const CircleOrLine& b);

/// A point of the projective plane, at/weight. At infinity in the direction of `at` for weight 0.
struct ProjectivePoint {
  Vec2d at;
  double weight = 0;
};

/// Empty for a point farther off than `reach`.
std::optional<Vec2d> finite(const ProjectivePoint& point, double reach);

/// The pole, where all motion vanishes: at infinity across the motion of a body that slides.
ProjectivePoint pole_point(const ContactSeries& series);

/// What has contact of four points with its tangent, beside the pole.
struct FourPointContact {
  /// How much has such contact.
  enum class Kind {
    none,   ///< the body stands, or slides without angular acceleration (to 1e-13)
    point,  ///< one point, perhaps at infinity or (a pole that is its own) the pole itself
    locus,  ///< every point of the inflection circle or line (to 1e-11)
  };
  Kind kind = Kind::none;
  ProjectivePoint ball;  ///< Ball's point, with max(|at|/size, |weight|) = 1, for `point`
};

/// `size`: the body's, a length near the longest of its mechanism.
FourPointContact four_point_contact(const ContactSeries& series, double size);

/// P₁ × Pₖ at a point of the projective plane, times weight²; its sign is the point's own.
double contact_value(const ContactSeries& series, int k, const ProjectivePoint& point);

/// The contact of the path of z with its tangent.
struct Contact {
  int points = 0;       ///< 2 for a path that curves; 0 where z stands still (the pole)
  Vec2d tangent{1, 0};  ///< unit vector, by growing τ
  /// Deviation from the tangent at a distance x along it is about coefficient·(x/size)^points·size.
  double coefficient = 0;
  /// The greatest of the coefficients that count as zero, each against the terms that cancel in it.
  double residual = 0;
};

/// A coefficient is zero below `tolerance` times the sizes of the terms that it is a sum of. Paths
/// straight beyond kContactOrder count as of kContactOrder + 1 points.
Contact contact(const ContactSeries& series, const Vec2d& z, double size, double tolerance = 1e-9);

}  // namespace cognate
