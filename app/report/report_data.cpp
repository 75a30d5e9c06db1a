#include "app/report/report_data.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "analysis/numbers/constants.hpp"
#include "app/report/design_drawing.hpp"
#include "app/report/drawn_findings.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;

ordered_json point_json(const Vec2d& point) {
  return {point.x, point.y};
}

/// Where the target of a design came: p → [x, y] + scale·R(deg) p.
ordered_json placement_json(const problems::CurvePlacement& placement) {
  return {{"scale", placement.scale},
          {"deg", kDegreesInRadian * placement.turn},
          {"shift", point_json(placement.shift)}};
}

ordered_json limits_json(const std::optional<problems::Range>& limits) {
  if (!limits) return nullptr;
  return {std::isfinite(limits->min) ? kDegreesInRadian * limits->min : 0,
          std::isfinite(limits->max) ? kDegreesInRadian * limits->max : 180};
}

}  // namespace

double round_to_digits(double x, int digits) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), x,
                                 std::chars_format::scientific, digits - 1)
                       .ptr;
  double rounded = x;
  std::from_chars(text.data(), end, rounded);
  return rounded;
}

ordered_json report_data(
    const problems::Result& result, const ordered_json& target,
    const std::optional<problems::Range>& transmission_limits,
    const std::function<ordered_json(const problems::Design& design)>& reached) {
  const Fineness finely = fineness(result.designs.size());
  ordered_json designs = ordered_json::array();
  for (const problems::Design& design : result.designs) {
    ordered_json entry = motion_of(design, finely);
    entry.update(reached(design));
    if (design.placement) entry["placement"] = placement_json(*design.placement);
    designs.push_back(entry);
  }
  return {{"target", target},
          {"transmission_limits_deg", limits_json(transmission_limits)},
          {"designs", designs},
          {"loci", drawn_loci(result.loci)},
          {"families", drawn_families(result.families)}};
}

}  // namespace cognate::app
