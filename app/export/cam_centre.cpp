#include "app/export/cam_centre.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/numbers/constants.hpp"

namespace cognate::app {
namespace {

/// The radius within which a cam whose curve this is holds material everywhere.
double least_radius(const CamOutline& curve, double kerf) {
  double least = kInfinity;
  for (const auto& point : curve.points) least = std::min(least, norm(point.at));
  // The nearest points of parallel curves lie on one normal through the centre.
  return least - (curve.base_radius - curve.profile_radius) - 0.5 * kerf;
}

/// Radially at cam angle 0, towards +y, in the outer part between bore and rim.
void add_timing_mark(double inside, double outside, Plan& plan) {
  constexpr double kFrom = 0.7, kTo = 0.9;
  plan.layers.push_back({"ENGRAVE", PlanColour::green});
  plan.outlines.push_back(plan_line("ENGRAVE", {0, std::lerp(inside, outside, kFrom)},
                                    {0, std::lerp(inside, outside, kTo)}));
}

/// The radius within which all cams hold material.
double body_of(const CamDrawing& drawing, double kerf) {
  double body = kInfinity;
  for (const auto& curve : drawing.curves) {
    if (curve.name != kOuterWall) body = std::min(body, least_radius(curve, kerf));
  }
  return body;
}

}  // namespace

tl::expected<WheelBore, std::string> cam_bore(const CamDrawing& drawing,
                                              const ExportOptions& wanted,
                                              std::optional<problems::LengthUnit> unit) {
  const double body = body_of(drawing, wanted.kerf);
  return wheel_bores(wanted.wheel, {{"cam", body, "least radius"}}, unit)
      .map([](const std::vector<WheelBore>& bores) { return bores.front(); });
}

tl::expected<void, std::string> add_cam_centre(const CamDrawing& drawing,
                                               const ExportOptions& wanted,
                                               std::optional<problems::LengthUnit> unit,
                                               Plan& plan) {
  const WheelOrder& order = wanted.wheel;
  if (order.bores.empty() && order.hubs.empty() && !order.timing_mark) return {};
  const auto made = cam_bore(drawing, wanted, unit);
  if (!made) return tl::unexpected(made.error());
  const WheelBore& bore = *made;
  const double body = body_of(drawing, wanted.kerf);
  plan.layers.push_back({"BORE"});
  plan.layers.push_back({"HUB", PlanColour::grey, true});
  if (order.timing_mark) add_timing_mark(std::max(bore.reach(), 0.5 * bore.hub), body, plan);
  return add_bore(bore, {}, {1, 0}, wanted.kerf, plan);
}

}  // namespace cognate::app
