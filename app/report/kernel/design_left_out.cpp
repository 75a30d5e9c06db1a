/// @file What the kernel of the pages leaves out of designs: the solvers of other libraries,
/// tolerances, layers and rasters, which a page does not pass on, and closed curves, of which it
/// passes on the points.
#include <nlohmann/json.hpp>

#include "app/documents/layers_json.hpp"
#include "app/documents/tolerance_json.hpp"
#include "problems/chain/raster/axes.hpp"
#include "problems/chain/read_tolerances.hpp"
#include "problems/dwell/raster.hpp"
#include "problems/layers/read.hpp"
#include "problems/linkage/design_layers.hpp"
#include "problems/linkage/read_raster.hpp"
#include "problems/path/read_curve.hpp"
#include "problems/raster/read.hpp"
#include "synthesis/optimise/gauss_newton.hpp"

namespace cognate {

synthesis::Solution synthesis::solve(Solver /*solver*/, const Model& model,
                                     std::span<const double> start, const Options& options) {
  return solve_gauss_newton(model, start, options);
}

nlohmann::ordered_json app::tolerance_json(const problems::ToleranceResult& /*given*/) {
  return nullptr;
}

nlohmann::ordered_json app::layers_json(const problems::LayerResult& /*given*/, bool /*slides*/) {
  return nullptr;
}

namespace problems {

bool reading::has_curve(TableReader& /*target*/, std::initializer_list<std::string_view> /*keys*/) {
  return false;
}

void reading::read_curve(TableReader& /*target*/, const std::filesystem::path& /*folder*/,
                         PathProblem& /*problem*/) {}

std::optional<Tolerances> reading::read_chain_tolerances(TableReader& /*document*/,
                                                         std::span<const Topology> /*topologies*/,
                                                         std::string_view /*unit*/) {
  return std::nullopt;
}

std::optional<Raster> reading::read_raster(TableReader& /*document*/,
                                           std::span<const std::string_view> /*keys*/,
                                           std::string_view /*refusal*/) {
  return std::nullopt;
}

std::optional<DimensionOffRaster> dimension_off_raster(const Raster& /*raster*/,
                                                       const Topology& /*topology*/) {
  return std::nullopt;
}

void reading::read_dwell_raster(TableReader& /*document*/, DwellProblem& /*problem*/) {}

std::string_view reading::robust_tolerance_refusal(const std::optional<Tolerances>& /*given*/) {
  return {};
}

std::optional<DesignLayers> reading::read_design_layers(TableReader& /*document*/,
                                                        TableReader& /*constraints*/,
                                                        const LinkNames& /*names*/,
                                                        std::string_view /*refusal*/) {
  return std::nullopt;
}

std::string_view layers_max_refusal(const Solve& /*solve*/) {
  return {};
}

}  // namespace problems
}  // namespace cognate
