#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include "problems/chain/raster/axes.hpp"
#include "problems/dwell/raster.hpp"
#include "problems/raster/keys.hpp"
#include "problems/raster/read.hpp"

namespace cognate::problems::reading {
namespace {

constexpr std::string_view kDwellRaster = "raster";
/// Boxes that branch and bound examines: half a minute.
constexpr int kDwellBoxes = 500;

const TopologyLine& crank_line(const Topology& topology) {
  return *std::ranges::find(topology.lines, synthesis::LineType::crank,
                            [](const TopologyLine& line) { return line.line.type; });
}

/// Without a length of the crank nothing says how large the mechanism is.
bool has_size(const Topology& topology) {
  const TopologyLine& crank = crank_line(topology);
  return crank.given[0] || std::isfinite(crank.bounds[0].max);
}

void check_axes(TableReader& document, const DwellProblem& problem) {
  const DwellSpace space(problem, problem.topologies.front());
  const ChainAxes all = chain_axes(*problem.raster, space, space.scale);
  if (all.axes.empty()) {
    document.fault(kDwellRaster, "puts no dimension on a raster that [mechanism] leaves open");
  }
  for (const synthesis::RasterAxis& axis : all.axes) {
    if (axis.values.count() > 0) continue;
    document.fault(kDwellRaster,
                   fmt::format("has no value of {} within its bounds; expected at least one: "
                               "widen the bounds or refine the raster",
                               axis.name));
  }
}

}  // namespace

void read_dwell_raster(TableReader& document, DwellProblem& problem) {
  constexpr std::array<std::string_view, 4> kKeys{"length", "pivots", "coupler_point", "crank"};
  if (!document.contains(kDwellRaster)) return;
  const bool is_one = problem.topologies.size() == 1;
  const std::string_view refusal =
      slides(problem) ? "is given with a slider as output; a raster is for outputs that turn"
      : !is_one
          ? "is given with a type of several topologies; expected a single one, as \"watt-2\", "
            "\"stephenson-3\" or \"chain\""
      : !has_size(problem.topologies.front())
          ? "is given without a length of the crank, which says how large the mechanism is; "
            "expected its length, bounds.length, or bounds by the name of the crank's pin"
          : "";
  const std::size_t faults_before = document.faults().size();
  problem.raster = read_raster(document, kKeys, refusal);
  if (document.faults().size() != faults_before) return;
  if (!document.table(kDwellRaster).contains(kRasterBoxesKey)) problem.raster->boxes = kDwellBoxes;
  check_axes(document, problem);
}

}  // namespace cognate::problems::reading
