#include "app/export/cam_drawing.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "problems/basics/degrees.hpp"
#include "problems/cam/extremes.hpp"

namespace cognate::app {
namespace {

using cam::Closure;
using problems::CamDesign;
using problems::CamProblem;

constexpr double kDefaultCamTolerance = 1e-4;  // of the base radius
constexpr double kLeastCamTolerance = 1e-9;    // as many points as can be handled
constexpr double kGreatestCutter = 1e6;        // of the base radius
constexpr std::size_t kMostPoints = 2'000'000;

/// A curve parallel to the one that the follower gives.
struct Parallel {
  std::string name;
  double distance = 0;
};

/// The curves of one cam.
std::vector<Parallel> parallels(const CamProblem& problem, double roller,
                                const DrawingOrder& order) {
  const bool groove = problem.second.closure == Closure::groove;
  const double cutter = order.cutter_radius.value_or(0);
  switch (order.kind) {
    case ExportedCurve::pitch:
      return {{"", 0}};
    case ExportedCurve::cutter:
      if (!groove) return {{"", cutter - roller}};
      if (cutter == roller) return {{"", 0}};
      return {{"inner-wall", cutter - roller}, {"outer-wall", roller - cutter}};
    default:
      if (!groove) return {{"", -roller}};
      return {{"inner-wall", -roller}, {"outer-wall", roller}};
  }
}

/// Why a cutter cannot cut `cam`; empty where it can.
std::optional<std::string> gouging(const CamProblem& problem, const cam::Cam& cam, double cutter) {
  const double roller = cam.system.follower.dimensions.roller_radius;
  if (problem.second.closure == Closure::groove && cutter > roller) {
    return fmt::format("--cutter-radius: {} does not fit into the groove; allowed is at most {}",
                       cutter, roller);
  }
  const auto hollow = problems::CamExtremes(cam).concave_radius();
  if (!hollow || cutter <= hollow->value) return std::nullopt;
  return fmt::format(
      "--cutter-radius: {} would gouge the profile, whose least concave radius is {:.6g}, at "
      "{:.4g} deg of the cam; allowed is at most that",
      cutter, hollow->value, problems::degrees(hollow->angle));
}

/// Why the order is not possible for this cam; empty where it is.
std::optional<std::string> refused_cam(const CamProblem& problem, const CamDesign& design,
                                       const DrawingOrder& order) {
  const auto& follower = design.cam.system.follower;
  if (order.kind == ExportedCurve::pitch && follower.dimensions.roller_radius == 0) {
    return "--curve: this follower has no roller, so there is no pitch curve; allowed is profile "
           "or cutter";
  }
  const double size = follower.dimensions.base_radius;
  const double tolerance = order.chord_tolerance.value_or(kDefaultCamTolerance * size);
  if (!(tolerance >= kLeastCamTolerance * size && tolerance <= size)) {
    return fmt::format(
        "--chord-tolerance: {} is not possible for a base radius of {}; allowed is a length from "
        "{:.3g} to {:.6g}",
        tolerance, size, kLeastCamTolerance * size, size);
  }
  if (order.kind != ExportedCurve::cutter) return std::nullopt;
  if (*order.cutter_radius > kGreatestCutter * size) {
    return fmt::format(
        "--cutter-radius: {} is too large for a base radius of {}; allowed is at most {:.6g}",
        *order.cutter_radius, size, kGreatestCutter * size);
  }
  auto why = gouging(problem, design.cam, *order.cutter_radius);
  if (!why && design.second) why = gouging(problem, *design.second, *order.cutter_radius);
  return why;
}

/// The curve's polygon as it lies on the shaft; `half_turn` where it was computed upside down.
std::vector<cam::ProfilePoint> placed_polygon(const cam::CamCurve& curve, double tolerance,
                                              bool half_turn, bool clockwise) {
  auto points = polygon(curve, tolerance, kMostPoints);
  const double y = half_turn ? -1 : 1;
  const double x = clockwise ? -y : y;
  for (auto& point : points) {
    point.at = {x * point.at.x, y * point.at.y};
    point.normal = {x * point.normal.x, y * point.normal.y};
  }
  return points;
}

class DrawingMaker {
 public:
  DrawingMaker(const CamProblem& problem, const DrawingOrder& order, double tolerance)
      : problem_(problem), order_(order), drawing_{order.kind, tolerance, {}, {}} {}

  /// Adds the curves of `cam`, named after it where there are two.
  void add(const cam::Cam& cam, const std::string& name, bool half_turn) {
    if (is_too_fine_) return;
    const auto& dimensions = cam.system.follower.dimensions;
    for (const auto& [wall, distance] : parallels(problem_, dimensions.roller_radius, order_)) {
      const cam::CamCurve curve{cam.system, cam.programme, distance};
      DrawnCurve drawn{
          name.empty() ? wall : name,
          placed_polygon(curve, drawing_.chord_tolerance, half_turn, problem_.clockwise),
          std::max(0.0, dimensions.base_radius + distance)};
      is_too_fine_ = drawn.points.size() >= kMostPoints;
      if (is_too_fine_) return;
      if (crosses_itself(drawn.points)) {
        drawing_.notes.push_back(
            fmt::format("the curve{}{} crosses itself: the cam is undercut there",
                        drawn.name.empty() ? "" : " ", drawn.name));
      }
      drawing_.curves.push_back(std::move(drawn));
    }
  }

  /// The drawing; an error where a curve has more points than it may have.
  tl::expected<CamDrawing, std::string> take() {
    if (!is_too_fine_) return std::move(drawing_);
    return tl::unexpected(fmt::format(
        "--chord-tolerance: {:.3g} would take more than {} points; allowed is a greater "
        "length",
        drawing_.chord_tolerance, kMostPoints));
  }

 private:
  const CamProblem& problem_;
  const DrawingOrder& order_;
  CamDrawing drawing_;
  bool is_too_fine_ = false;
};

}  // namespace

tl::expected<CamDrawing, std::string> cam_drawing(const CamProblem& problem,
                                                  const CamDesign& design,
                                                  const DrawingOrder& order) {
  if (const auto why = refused_cam(problem, design, order)) return tl::unexpected(*why);
  const auto& follower = design.cam.system.follower;
  DrawingMaker maker(
      problem, order,
      order.chord_tolerance.value_or(kDefaultCamTolerance * follower.dimensions.base_radius));
  maker.add(design.cam, design.second ? "cam-1" : "", false);
  // The second roller of a translating follower is below the shaft; a swinging one has its pivot
  // where the first has it.
  if (design.second) maker.add(*design.second, "cam-2", !is_oscillating(follower.type));
  return maker.take();
}

double reach_of(const CamDrawing& drawing) {
  double reach = 0;
  for (const auto& curve : drawing.curves) {
    reach = std::max(reach, curve.base_radius);
    for (const auto& point : curve.points) {
      reach = std::max({reach, std::abs(point.at.x), std::abs(point.at.y)});
    }
  }
  return reach;
}

}  // namespace cognate::app
