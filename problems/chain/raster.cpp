#include "problems/chain/raster.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "problems/chain/refine.hpp"
#include "problems/linkage/verify.hpp"

namespace cognate::problems {
namespace {

using synthesis::LineType;
using synthesis::RasterBox;
using synthesis::RasterNumbers;
using synthesis::RasterPoint;

constexpr double kRelaxedTolerance = 1e-10;
constexpr int kRelaxedIterations = 60;
constexpr double kChainFeasibility = 1e-9;  ///< of a cosine

/// A parameter on the raster: a value is origin + size times it.
struct ChainAxis {
  std::size_t parameter;
  double origin, size;
};

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
    case LineType::dyad:
      break;
  }
  return link_names(point(line.line.first), point(line.line.second), line.name)[index];
}

struct ChainAxes {
  std::vector<synthesis::RasterAxis> axes;
  std::vector<ChainAxis> places;
};

ChainAxes axes_of(const Raster& raster, const ScaledChain& scaled, const TargetScale& scale) {
  ChainAxes all;
  const Topology& topology = *scaled.topology;
  std::size_t parameter = 0;
  for (const TopologyLine& line : topology.lines) {
    const auto count = static_cast<std::size_t>(synthesis::parameter_count(line.line.type));
    for (std::size_t i = 0; i < count; ++i, ++parameter) {
      const bool is_crank = line.line.type == LineType::crank;
      const RasterRule* rule = raster.rule(is_crank ? "crank" : "", group_of(line.line.type));
      if (rule == nullptr || scaled.given[parameter]) continue;
      const bool is_place = line.line.type == LineType::pivot;
      const double origin = !is_place ? 0 : i == 0 ? scale.centre.x : scale.centre.y;
      Range range{origin + scale.size * scaled.lower[parameter],
                  origin + scale.size * scaled.upper[parameter]};
      const bool is_length = is_crank || line.line.type == LineType::dyad;
      if (is_length && rule->step) range.min = std::max(range.min, 0.5 * *rule->step);
      all.axes.push_back({name_of(topology, line, i), values_within(*rule, range, range)});
      all.places.push_back({parameter, origin, scale.size});
    }
  }
  return all;
}

class ChainRaster final : public synthesis::RasterTask {
 public:
  ChainRaster(const Raster& raster, const ScaledChain& scaled, const TargetScale& scale,
              const ChainAcceptance& accepts)
      : scaled_(scaled), scale_(scale), accepts_(accepts), all_(axes_of(raster, scaled, scale)) {}

  std::span<const synthesis::RasterAxis> axes() const override { return all_.axes; }

  std::vector<RasterPoint> relax(const RasterBox& box,
                                 std::span<const RasterPoint> from) const override {
    const ScaledChain restricted = within(box);
    std::vector<RasterPoint> minima;
    for (const RasterPoint& start : from) {
      auto found = relaxed(restricted, start);
      const auto same = [&](const RasterPoint& known) {
        return known.form == found.form &&
               std::abs(known.objective - found.objective) <= 1e-9 * known.objective;
      };
      if (std::isfinite(found.objective) && std::ranges::none_of(minima, same)) {
        minima.push_back(std::move(found));
      }
    }
    return minima;
  }

  bool accepts(const RasterPoint& point) const override { return accepts_(chain(point)); }

  RasterPoint point(const FoundChain& found) const {
    return point_of({found.design, found.angles, found.rms * found.rms});
  }

  RasterChain chain(const RasterPoint& point) const {
    RasterChain made{scale_.out_of(scaled_.chain, design_of(point)), angles_of(point)};
    for (std::size_t i = 0; i < all_.places.size(); ++i) {
      // Without the rounding of the scale.
      const auto& values = all_.axes[i].values;
      made.design.parameters[all_.places[i].parameter] = values.at(values.nearest(point.values[i]));
    }
    return made;
  }

 private:
  ScaledChain within(const RasterBox& box) const {
    ScaledChain restricted = scaled_;
    for (std::size_t i = 0; i < all_.places.size(); ++i) {
      const auto& [parameter, origin, size] = all_.places[i];
      const double low = (all_.axes[i].values.at(box.first[i]) - origin) / size;
      const double high = (all_.axes[i].values.at(box.last[i]) - origin) / size;
      restricted.lower[parameter] = low;
      restricted.upper[parameter] = high;
      if (box.first[i] == box.last[i]) restricted.given[parameter] = low;
    }
    restricted.free.clear();
    for (std::size_t i = 0; i < restricted.given.size(); ++i) {
      if (!restricted.given[i]) restricted.free.push_back(static_cast<int>(i));
    }
    return restricted;
  }

  RasterPoint relaxed(const ScaledChain& restricted, const RasterPoint& from) const {
    synthesis::ChainDesign design = design_of(from);
    for (std::size_t i = 0; i < design.parameters.size(); ++i) {
      design.parameters[i] = restricted.given[i].value_or(
          std::clamp(design.parameters[i], restricted.lower[i], restricted.upper[i]));
    }
    return point_of(refine(restricted, design, angles_of(from), synthesis::Solver::gauss_newton,
                           {.tolerance = kRelaxedTolerance, .max_iterations = kRelaxedIterations}));
  }

  /// The parameters, then the angles; the sides as the form, a bit for each line to the left.
  RasterPoint point_of(const RefinedChain& refined) const {
    RasterPoint made;
    made.objective = refined.objective;
    made.violation = refined.violation;
    made.x = refined.design.parameters;
    made.x.insert(made.x.end(), refined.angles.begin(), refined.angles.end());
    for (std::size_t i = 0; i < refined.design.side.size(); ++i) {
      if (refined.design.side[i] > 0) made.form |= 1 << i;
    }
    for (const auto& [parameter, origin, size] : all_.places) {
      made.values.push_back(origin + size * made.x[parameter]);
    }
    return made;
  }

  synthesis::ChainDesign design_of(const RasterPoint& point) const {
    synthesis::ChainDesign design;
    const auto count = static_cast<std::ptrdiff_t>(scaled_.given.size());
    design.parameters.assign(point.x.begin(), point.x.begin() + count);
    for (std::size_t i = 0; i < scaled_.lines.size(); ++i) {
      const bool is_dyad = scaled_.lines[i].line.type == LineType::dyad;
      design.side.push_back(!is_dyad ? 0 : (point.form & (1 << i)) != 0 ? 1 : -1);
    }
    return design;
  }

  std::vector<double> angles_of(const RasterPoint& point) const {
    return {point.x.begin() + static_cast<std::ptrdiff_t>(scaled_.given.size()), point.x.end()};
  }

  const ScaledChain& scaled_;
  const TargetScale& scale_;
  const ChainAcceptance& accepts_;
  ChainAxes all_;
};

}  // namespace

RasterChainResult search_chain_raster(const ChainPathProblem& problem, const ScaledChain& scaled,
                                      const TargetScale& scale,
                                      const std::vector<FoundChain>& found,
                                      const ChainAcceptance& accepts, const Run& run,
                                      const Deadline& deadline) {
  const ChainRaster raster(*problem.raster, scaled, scale, accepts);
  std::vector<RasterPoint> from;
  for (const FoundChain& one : found) from.push_back(raster.point(one));
  RasterChainResult result;
  result.search =
      synthesis::search_raster(raster, from,
                               {.feasibility = kChainFeasibility,
                                .met = kMetExactly,
                                .designs = static_cast<std::size_t>(problem.solve.designs),
                                .most_nodes = static_cast<std::uint64_t>(problem.raster->boxes),
                                .threads = run.threads,
                                .deadline = &deadline,
                                .progress = run.progress});
  for (const RasterPoint& point : result.search.designs) {
    result.designs.push_back(raster.chain(point));
  }
  return result;
}

}  // namespace cognate::problems
