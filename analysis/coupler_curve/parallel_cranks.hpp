/// @file Four-bars whose cranks are parallel: the coupler slides, its pole is at infinity.
///
/// The coupler's angular velocity is zero and its angular acceleration is not, so that the points
/// without curvature lie on a straight line parallel to the cranks. In axes with the origin at B, y
/// from A to B and x across, with a = AB, b = BC, c = DC, φ the angle of B→C from x, the curvature
/// of a point's path (concave towards +y positive) goes linearly with its x,
///
///     κ = κ_B + (κ_C − κ_B) x/(b cos φ),   κ_B = −1/a,   κ_C = ∓1/c,
///
/// − for cranks to the same side, + for opposite ones, and along the line of κ = 0 its derivative
/// by the length of the path is ±3 tan φ/(a c): no point has contact of four points with its
/// tangent unless the coupler stands across the cranks, and then all of the line have. Wang, Zhu,
/// Liao & Yang, 2007, on approximate straight-line linkages with the instant centre at infinity;
/// its equations are corrected here as derivatives of the motion require.
#pragma once

#include <optional>

#include "analysis/linkage/four_bar.hpp"
#include "analysis/numbers/vec2.hpp"

namespace cognate {

/// Whether the cranks A→B and D→C point to the same side or to opposite ones.
enum class CrankSides { same, opposite };

/// Lengths positive and in one unit; `coupler_angle` φ in radians from the direction across the
/// cranks, which is −90° from A→B.
struct ParallelCranks {
  double crank = 0;
  double coupler = 0;
  double rocker = 0;
  double coupler_angle = 0;
  CrankSides sides = CrankSides::same;
};

/// The pivot D and the joint C, from A = (0, 0) and B = (0, crank) of a crank that stands along +y.
struct ParallelPose {
  Vec2d b;
  Vec2d c;
  Vec2d d;
};
ParallelPose pose(const ParallelCranks& cranks);

/// The four-bar with A at the origin that stands so at the crank angle 90°. Empty where the
/// assembly is undetermined, the coupler in line with the cranks (cos φ = 0 to 1e-9).
std::optional<FourBar> four_bar(const ParallelCranks& cranks);

/// The curvature of the path of the point with the coordinate x (origin B), by the formula above.
double path_curvature(const ParallelCranks& cranks, double x);

/// The x of the inflection line, b cos φ · c/(c ∓ a). Empty for equal cranks to the same side (to
/// 16 ε): every path then has the curvature of the cranks, as in a parallelogram.
std::optional<double> inflection_line_x(const ParallelCranks& cranks);

/// The point of the inflection line on the coupler line, from B: B→C times c/(c ∓ a), at the signed
/// distances a b/(a − c) or a b/(a + c) from C towards B.
std::optional<Vec2d> coupler_line_point(const ParallelCranks& cranks);

/// The same point by its graphical construction: the parallel to BC through A meets the crank DC,
/// the one through D meets the crank AB, and the line that joins them meets BC in the point.
std::optional<Vec2d> constructed_point(const ParallelCranks& cranks);

/// The point with contact of five points, from B, of a coupler across the cranks (φ = 0):
/// (b c/(c − a), (a + c) b²/(c − a)²) for cranks to the same side, (b c/(a + c), (a − c) b²/(a +
/// c)²) for opposite ones, where a = c is Watt's linkage. Empty where the inflection line is, and
/// where |sin φ| > 1e-12.
std::optional<Vec2d> five_point_contact(const ParallelCranks& cranks);

/// dκ/ds along the inflection line, 3 tan φ/(a c) for a point that moves towards +x with the sign
/// of cranks to the same side.
double curvature_rate(const ParallelCranks& cranks);

}  // namespace cognate
