#include "app/drawing/cam_plan.hpp"

namespace cognate::app {
namespace {

/// Half a line of the mark at the cam's centre, as a share of the reach.
constexpr double kCamCentreMark = 0.04;

const char* layer_of(CamCurveKind kind) {
  switch (kind) {
    case CamCurveKind::pitch:
      return "PITCH";
    case CamCurveKind::cutter:
      return "CUTTER";
    default:
      return "PROFILE";
  }
}

PlanOutline outline_of(const CamOutline& curve, const char* layer) {
  PlanOutline outline{layer, {}, true};
  outline.corners.reserve(curve.points.size());
  for (const auto& point : curve.points) outline.corners.push_back({point.at});
  return outline;
}

}  // namespace

Plan cam_plan(const CamDrawing& drawing, const std::string& title) {
  const char* layer = layer_of(drawing.kind);
  const double reach = reach_of(drawing);
  const PlanColour colour =
      drawing.kind == CamCurveKind::profile ? PlanColour::foreground : PlanColour::accent;
  Plan plan{
      .title = title.empty() ? "Cam" : title,
      .low = {-reach, -reach},
      .high = {reach, reach},
      .layers = {
          {layer, colour}, {"BASE_CIRCLE", PlanColour::grey, true}, {"CENTRE", PlanColour::red}}};
  for (const auto& curve : drawing.curves) {
    plan.outlines.push_back(outline_of(curve, layer));
    if (curve.base_radius > 0) plan.circles.push_back({"BASE_CIRCLE", {}, curve.base_radius});
  }
  const double arm = kCamCentreMark * reach;
  plan.outlines.push_back(plan_line("CENTRE", {-arm, 0}, {arm, 0}));
  plan.outlines.push_back(plan_line("CENTRE", {0, -arm}, {0, arm}));
  return plan;
}

}  // namespace cognate::app
