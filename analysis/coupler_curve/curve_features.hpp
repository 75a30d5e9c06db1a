/// @file What a coupler curve has as a whole: its cusps, double points and inflections.
///
/// The curve is a tricircular sextic. Its three finite double points, so far as they are real and
/// on the traced curve, lie on the circle of singular foci, through A, D and the third pivot E of
/// Roberts' cognates: of the twelve points common to sextic and circle six are the circular points
/// at infinity, and the double points count twice each. So the curve meets that circle nowhere
/// else, and a double point is found where one motion crosses the circle. Hunt, Kinematic Geometry
/// of Mechanisms, 1978, chapter 7; Hartenberg & Denavit, Kinematic Synthesis of Linkages, 1964.
#pragma once

#include <optional>
#include <vector>

#include "analysis/coupler_curve/circuit_samples.hpp"
#include "analysis/linkage/defects.hpp"
#include "analysis/linkage/four_bar.hpp"
#include "analysis/numbers/vec2.hpp"

namespace cognate {

/// A place of the curve and where the linkage stands there. Circuits are numbered: of a crank that
/// turns fully, 0 the open assembly and 1 the crossed; otherwise one for each of `crank_ranges`.
struct CurvePoint {
  Vec2d at;
  CrankPosition position;  ///< crank angle in [0, 2π)
  int circuit = 0;
};

/// Where the curve passes twice, in two positions of the linkage, which may be of two circuits.
struct DoublePoint {
  Vec2d at;
  CurvePoint first;
  CurvePoint second;
};

/// The cusps, inflections and double points of a curve.
struct CurveFeatures {
  std::vector<CurvePoint> cusps;
  std::vector<CurvePoint> inflections;
  std::vector<DoublePoint> double_points;
};

/// The features of all that the coupler point can trace, on every circuit and in both assemblies,
/// found to rounding. `linkage.assembly` says nothing here: take of the result what is on its
/// circuit.
///
/// A cusp is where the point stands still to 1e-10 of the speeds that it is composed of. An
/// inflection is a change of sign of the curvature, so that a point of undulation (as Ball's point
/// with stationary curvature) is none. Inflections and double points as near to a cusp as rounding
/// makes them are taken for the cusp. Features of one kind closer than a 480th of an arc of its
/// circuit (a turn has one, other circuits four) may be missed if there are more than two.
///
/// Empty without a coupler point, where the linkage cannot be assembled, and where the point is on
/// B or C, whose path is a circle.
std::optional<CurveFeatures> curve_features(const FourBar& linkage);

/// Those on one circuit; of double points those whose both passages are on it.
std::optional<CurveFeatures> curve_features(const FourBar& linkage, const CircuitChoice& circuit);

}  // namespace cognate
