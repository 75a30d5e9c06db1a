#include "app/drawing/cam_drawing.hpp"

#include <algorithm>
#include <cmath>

namespace cognate::app {
namespace {

using cam::Closure;
using problems::CamDesign;
using problems::CamProblem;

/// The curve's polygon as it lies on the shaft; `half_turn` where it was computed upside down.
std::vector<cam::ProfilePoint> placed_polygon(const cam::CamCurve& curve, double tolerance,
                                              bool half_turn, bool clockwise) {
  auto points = polygon(curve, tolerance, kMostCamPoints);
  const double y = half_turn ? -1 : 1;
  const double x = clockwise ? -y : y;
  for (auto& point : points) {
    point.at = {x * point.at.x, y * point.at.y};
    point.normal = {x * point.normal.x, y * point.normal.y};
  }
  return points;
}

/// Adds the curves of `cam` to `drawing`, named after it where there are two cams; false where one
/// has too many points.
bool add_curves(const CamProblem& problem, const cam::Cam& cam, const std::string& name,
                bool half_turn, const CamDrawingOptions& options, CamDrawing& drawing) {
  for (auto& [wall, distance] :
       parallel_curves(problem, cam, options.kind, options.cutter_radius)) {
    // The beam is outside the material, which is outside an outer wall.
    const double beam = wall == kOuterWall ? -0.5 * options.kerf : 0.5 * options.kerf;
    const cam::CamCurve curve{cam.system, cam.programme, distance + beam};
    const auto& dimensions = cam.system.follower.dimensions;
    const double prime = dimensions.base_radius, roller = dimensions.roller_radius;
    CamOutline outline{name.empty() ? wall : name,
                       placed_polygon(curve, options.chord_tolerance, half_turn, problem.clockwise),
                       std::max(0.0, prime + distance)};
    outline.profile_radius =
        options.kind == CamCurveKind::profile ? outline.base_radius : std::max(0.0, prime - roller);
    outline.prime_radius = roller > 0 ? prime : 0;
    if (outline.points.size() >= kMostCamPoints) return false;
    outline.crosses_itself = crosses_itself(outline.points);
    drawing.curves.push_back(std::move(outline));
  }
  return true;
}

}  // namespace

std::vector<ParallelCurve> parallel_curves(const CamProblem& problem, const cam::Cam& cam,
                                           CamCurveKind kind, double cutter_radius) {
  const bool groove = problem.second.closure == Closure::groove;
  const double roller = cam.system.follower.dimensions.roller_radius;
  if (kind == CamCurveKind::pitch) return {{"", 0}};
  const double inside = kind == CamCurveKind::cutter ? cutter_radius - roller : -roller;
  if (!groove || inside == 0) return {{"", inside}};
  return {{"inner-wall", inside}, {kOuterWall, -inside}};
}

std::optional<CamDrawing> cam_drawing(const CamProblem& problem, const CamDesign& design,
                                      const CamDrawingOptions& options) {
  CamDrawing drawing{options.kind, options.chord_tolerance, {}};
  // The second roller of a translating follower is below the shaft; a swinging one has its pivot
  // where the first has it.
  const bool half_turn = !is_oscillating(design.cam.system.follower.type);
  const bool drawn =
      add_curves(problem, design.cam, design.second ? "cam-1" : "", false, options, drawing) &&
      (!design.second || add_curves(problem, *design.second, "cam-2", half_turn, options, drawing));
  return drawn ? std::optional(std::move(drawing)) : std::nullopt;
}

double reach_of(const CamDrawing& drawing) {
  double reach = 0;
  for (const auto& curve : drawing.curves) {
    reach = std::max({reach, curve.base_radius, curve.prime_radius});
    for (const auto& point : curve.points) {
      reach = std::max({reach, std::abs(point.at.x), std::abs(point.at.y)});
    }
  }
  return reach;
}

}  // namespace cognate::app
