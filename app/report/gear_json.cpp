#include "app/report/gear_json.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "analysis/gear/tooth_outline.hpp"
#include "analysis/numbers/constants.hpp"
#include "app/report/mechanism_json.hpp"

namespace cognate::app {

using nlohmann::ordered_json;

double gear_fineness(std::size_t designs) {
  constexpr double kFine = 2e-4, kCoarse = 1e-3;
  constexpr std::size_t kMany = 40;
  return designs <= kMany ? kFine : kCoarse;
}

ordered_json gear_json(const gear::SpurGear& gear, double fineness) {
  ordered_json x = ordered_json::array(), y = x, part = x;
  for (const auto& point : gear::tooth_half(gear, fineness * gear.module)) {
    x.push_back(drawn(point.at.x));
    y.push_back(drawn(point.at.y));
    part.push_back(static_cast<int>(point.part));
  }
  return {{"teeth", drawn(gear.teeth)},
          {"module", drawn(gear.module)},
          {"reference", drawn(gear::reference_radius(gear))},
          {"base", drawn(gear::base_radius(gear))},
          {"tip", drawn(gear::tip_radius(gear))},
          {"root", drawn(gear::root_radius(gear))},
          {"form", x.empty() ? ordered_json(nullptr) : drawn(gear::form_radius(gear))},
          {"half_angle", drawn(gear::base_half_angle(gear))},
          {"pressure_angle", drawn(gear.rack.pressure_angle)},
          {"half", {{"x", x}, {"y", y}, {"part", part}}}};
}

ordered_json rack_json(const gear::SpurGear& gear, double fineness) {
  const double half_pitch = kRightAngle * gear.module;
  ordered_json x = ordered_json::array(), y = x;
  double last = -half_pitch;
  for (const auto& at : gear::rack_outline(gear, 0, 1, fineness * gear.module)) {
    if (at.x <= last || at.x >= half_pitch) continue;
    last = at.x;
    x.push_back(drawn(at.x));
    y.push_back(drawn(at.y));
  }
  return {{"x", x}, {"y", y}};
}

}  // namespace cognate::app
