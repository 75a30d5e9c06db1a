#include "problems/chain/raster/axes.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

namespace cognate::problems {
namespace {

using synthesis::LineType;

std::string_view group_of(LineType type) {
  return type == LineType::pivot ? "pivots" : type == LineType::attached ? "coupler_point" : "";
}

/// What users call parameter `index` of a line.
std::string name_of(const Topology& topology, const TopologyLine& line, std::size_t index) {
  const auto point = [&](int at) { return topology.lines[static_cast<std::size_t>(at)].name; };
  switch (line.line.type) {
    case LineType::pivot:
      return line.name + (index == 0 ? ".x" : ".y");
    case LineType::attached:
      return line.name + (index == 0 ? ".u" : ".v");
    case LineType::crank:
      return "crank";
    default:
      break;
  }
  return link_names(point(line.line.first), point(line.line.second), line.name)[index];
}

/// What holds for the dimensions of a line; null where any value will do, as of guides.
const RasterRule* rule_of(const Raster& raster, LineType type) {
  if (type == LineType::guide) return nullptr;
  return raster.rule(type == LineType::crank ? "crank" : "", group_of(type));
}

}  // namespace

std::optional<DimensionOffRaster> dimension_off_raster(const Raster& raster,
                                                       const Topology& topology) {
  for (const TopologyLine& line : topology.lines) {
    const RasterRule* rule = rule_of(raster, line.line.type);
    if (rule == nullptr) continue;
    const auto count = static_cast<std::size_t>(synthesis::parameter_count(line.line.type));
    for (std::size_t i = 0; i < count; ++i) {
      const Range& bounds = line.bounds[i];
      if (line.given[i] || !std::isfinite(bounds.max - bounds.min)) continue;
      if (values_within(*rule, bounds, bounds).count() > 0) continue;
      return DimensionOffRaster{name_of(topology, line, i), bounds};
    }
  }
  return std::nullopt;
}

ChainAxes chain_axes(const Raster& raster, const ChainSpace& scaled, const TargetScale& scale) {
  ChainAxes all;
  const Topology& topology = *scaled.topology;
  std::size_t parameter = 0;
  for (const TopologyLine& line : topology.lines) {
    const auto count = static_cast<std::size_t>(synthesis::parameter_count(line.line.type));
    for (std::size_t i = 0; i < count; ++i, ++parameter) {
      const RasterRule* rule = rule_of(raster, line.line.type);
      if (rule == nullptr || scaled.given[parameter]) continue;
      const bool is_place = line.line.type == LineType::pivot;
      const double origin = !is_place ? 0 : i == 0 ? scale.centre.x : scale.centre.y;
      Range range{origin + scale.size * scaled.lower[parameter],
                  origin + scale.size * scaled.upper[parameter]};
      if (has_lengths(line.line.type) && rule->step)
        range.min = std::max(range.min, 0.5 * *rule->step);
      all.axes.push_back({name_of(topology, line, i), values_within(*rule, range, range)});
      all.places.push_back({parameter, origin, scale.size});
    }
  }
  return all;
}

}  // namespace cognate::problems
