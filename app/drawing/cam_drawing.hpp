/// @file The curves of a cam.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "analysis/cam/profile.hpp"
#include "problems/cam/result.hpp"

namespace cognate::app {

/// The profile, the path of the roller's centre, or that of the centre of a cutter.
enum class CamCurveKind { profile, pitch, cutter };

/// The wall of a groove that lies about the roller's path; material is outside it.
inline constexpr const char* kOuterWall = "outer-wall";

/// A curve parallel to the pitch curve (of a flat face: to the profile).
struct ParallelCurve {
  std::string name;  ///< "inner-wall" or "outer-wall" of a groove; empty where it is the only one
  double distance = 0;  ///< outside the pitch curve
};

/// The curves of `kind` about `cam`, the inner wall of a groove first.
std::vector<ParallelCurve> parallel_curves(const problems::CamProblem& problem, const cam::Cam& cam,
                                           CamCurveKind kind, double cutter_radius = 0);

/// One closed curve as a polygon; its last point is joined to its first.
struct CamOutline {
  std::string name;  ///< "outer-wall", "cam-2"; empty where the drawing has one curve alone
  std::vector<cam::ProfilePoint> points;
  /// Of the circle about the cam's centre on which the curve lies at displacement 0.
  double base_radius = 0;
  double profile_radius = 0;  ///< of the base circle, on which the cam's profile lies there
  double prime_radius = 0;    ///< of the prime circle of a roller's pitch curve; 0 without roller
  bool crosses_itself = false;
};

/// The curves of one kind, as they lie on the shaft at cam angle 0: origin at its centre, +y along
/// the follower's travel or from the centre to its pivot.
struct CamDrawing {
  CamCurveKind kind = CamCurveKind::profile;
  double chord_tolerance = 0;
  std::vector<CamOutline> curves;
};

/// What a drawing is to hold, and how close its chords are to the curves.
struct CamDrawingOptions {
  CamCurveKind kind = CamCurveKind::profile;
  double cutter_radius = 0;  ///< where `kind` is cutter
  double chord_tolerance = 0;
  double kerf = 0;  ///< of a profile: width of the beam whose middle runs along what is drawn
};

/// Points that a curve of a drawing has at most.
inline constexpr std::size_t kMostCamPoints = 2'000'000;

/// The drawing of `design`, whose problem is `problem`: the walls of a groove are two curves, so
/// are the cams of a conjugate pair; a cam that turns clockwise is the mirror image of the
/// kernel's. Empty where a curve would take more points than it may have.
std::optional<CamDrawing> cam_drawing(const problems::CamProblem& problem,
                                      const problems::CamDesign& design,
                                      const CamDrawingOptions& options);

/// Half the side of the least square about the origin that holds `drawing`.
double reach_of(const CamDrawing& drawing);

}  // namespace cognate::app
