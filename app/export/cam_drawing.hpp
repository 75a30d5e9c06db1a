/// @file The curves of a cam as they are exported.
#pragma once

#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "analysis/cam/profile.hpp"
#include "problems/cam/result.hpp"

namespace cognate::app {

/// Which curve is wanted: the profile, the path of the roller's centre, that of a cutter's centre.
enum class ExportedCurve { profile, pitch, cutter };

/// What a drawing is to hold, and how close to the truth.
struct DrawingOrder {
  ExportedCurve kind = ExportedCurve::profile;
  std::optional<double> cutter_radius;    ///< where `kind` is cutter
  std::optional<double> chord_tolerance;  ///< empty: 1e-4 of the base radius
};

/// One closed curve as a polygon; its last point is joined to its first.
struct DrawnCurve {
  std::string name;  ///< "outer-wall"; empty where the drawing has one curve alone
  std::vector<cam::ProfilePoint> points;
  /// Of the circle about the cam's centre on which the curve lies at displacement 0.
  double base_radius = 0;
};

/// The curves of one kind, as they lie on the shaft at cam angle 0: origin at its centre, +y along
/// the follower's travel or from the centre to its pivot.
struct CamDrawing {
  ExportedCurve kind = ExportedCurve::profile;
  double chord_tolerance = 0;
  std::vector<DrawnCurve> curves;
  std::vector<std::string> notes;  ///< of curves that cross themselves
};

/// The drawing of `design`, whose problem is `problem`: the walls of a groove are two curves, so
/// are the cams of a conjugate pair; a cam that turns clockwise is the mirror image of the
/// kernel's. The error says which part of the order is not possible and what is allowed: no pitch
/// curve without a roller, no cutter larger than the least concave radius of the profile, than the
/// groove or than a million base radii, a chord tolerance from 1e-9 to 1 of the base radius that
/// takes at most two million points.
tl::expected<CamDrawing, std::string> cam_drawing(const problems::CamProblem& problem,
                                                  const problems::CamDesign& design,
                                                  const DrawingOrder& order);

/// Half the side of the least square about the origin that holds `drawing`.
double reach_of(const CamDrawing& drawing);

}  // namespace cognate::app
