#include "app/study/metric_unit.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "app/kinds/kinds.hpp"
#include "app/study/metrics.hpp"

namespace cognate::app {
namespace {

/// What names end with or have before the part they belong to.
constexpr std::array<std::pair<std::string_view, std::string_view>, 3> kNamed = {
    {{"_deg", "deg"}, {"_N_m", "N m"}, {"_N", "N"}}};

/// Keys of mechanisms and bounds that hold a length.
constexpr std::array<std::string_view, 12> kLengths = {
    "crank",       "coupler",       "rocker",          "frame", "offset",      "length",
    "base_radius", "roller_radius", "centre_distance", "arm",   "face_offset", "stroke"};

/// Whether `part` ends `name` or stands before the part it belongs to.
bool ends_part(std::string_view name, std::string_view part) {
  const auto at = name.find(part);
  if (at == std::string_view::npos) return false;
  const auto behind = name.substr(at + part.size());
  return behind.empty() || behind.front() == '.';
}

std::string unit_in(std::string_view name) {
  for (const auto& [part, unit] : kNamed) {
    const auto at = name.find(part);
    if (at == std::string_view::npos) continue;
    const auto behind = name.substr(at + part.size());
    if (behind.empty() || behind.front() == '.' || behind.front() == '_') return std::string(unit);
  }
  return "";
}

/// A metric of a gear of a pair without the gear's name.
std::string_view of_gear(std::string_view name) {
  for (const std::string_view gear : {"pinion.", "wheel.", "worm."}) {
    if (name.starts_with(gear)) return name.substr(gear.size());
  }
  return name;
}

}  // namespace

std::string metric_unit(std::string_view name) {
  if (ends_part(name, "_at_deg")) return "deg";
  if (ends_part(name, "_at")) return "length";
  name = of_gear(name);
  for (const MetricList& list : metric_lists()) {
    if (!list.of_design) continue;
    for (const Metric& metric : list.metrics) {
      const auto keys = single_keys(metric.key);
      if (std::ranges::find(keys, name) == keys.end()) continue;
      const bool is_bare = metric.unit == "1" || metric.unit == "boolean";
      return is_bare ? "" : std::string(metric.unit);
    }
  }
  const auto key = name.substr(name.rfind('.') + 1);
  if (std::ranges::find(kLengths, key) != kLengths.end()) return "length";
  return unit_in(name);
}

}  // namespace cognate::app
