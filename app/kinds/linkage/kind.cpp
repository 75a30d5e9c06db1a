#include "app/kinds/linkage/kind.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "app/documents/layers_catalogue.hpp"
#include "app/documents/mechanism_catalogue.hpp"
#include "app/documents/tolerance_catalogue.hpp"
#include "app/export/parts/stacked_parts.hpp"
#include "app/report/filled_page.hpp"
#include "app/study/metrics.hpp"
#include "problems/linkage/design_layers.hpp"
#include "problems/mechanism/dimensions.hpp"

namespace cognate::app {
namespace {

using problems::MetricNames;

/// The tables and keys that the mechanism of a design may have.
void add_mechanisms(MetricNames& names) {
  for (const KeyedEntry& mechanism : mechanisms()) {
    if (mechanism.name == "chain") continue;
    for (const Entry& key : mechanism.keys) {
      names.openings.push_back(fmt::format("mechanism.{}", key.name));
    }
  }
  for (const char* table : {"type", "pivot", "slider", "dyad", "point"}) {
    names.openings.push_back(fmt::format("mechanism.{}", table));
  }
}

}  // namespace

MetricNames linkage_metric_names() {
  MetricNames names;
  add_metrics(names, metrics());
  add_metrics(names, kToleranceMetrics);
  add_metrics(names, kLayersMetrics);
  add_metrics(names,
              study_extras().first(study_extras().size() - 2));  // the last two stand for many
  add_metrics(names, quantities(), "facts.");
  add_mechanisms(names);
  names.openings.emplace_back("crank_deg");
  return names;
}

MetricNames chain_metric_names(std::span<const problems::Topology> topologies) {
  MetricNames names = linkage_metric_names();
  for (const problems::Topology& topology : topologies) {
    for (const problems::TopologyLine& line : topology.lines) {
      if (!is_dyad(line.line.type) && !is_three_pin(line.line.type)) continue;
      names.names.push_back({fmt::format("transmission_{}_min_deg", line.name)});
    }
  }
  return names;
}

std::string linkage_page(bool moves, const problems::Result& result) {
  const auto is_four_bar = [](const auto& design) { return bool(design.mechanism.four_bar()); };
  const bool needed = moves && !std::ranges::all_of(result.designs, is_four_bar);
  return needed ? design_page() : without_kernel(design_page(), "mechanism-kernel");
}

void add_size(nlohmann::ordered_json& metrics, const problems::NamedMechanism& mechanism) {
  if (!mechanism.four_bar()) return;
  const auto [shortest, longest] =
      std::ranges::minmax(main_dimensions(mechanism), {}, &problems::Dimension::value);
  metrics["longest_link"] = longest.value;
  metrics["link_ratio"] = longest.value / shortest.value;
}

void add_bills(const problems::Result& result, const problems::LayerSizes& sizes,
               nlohmann::ordered_json& data) {
  constexpr std::size_t kMostBills = 10;
  const std::size_t count = std::min(result.designs.size(), kMostBills);
  for (std::size_t i = 0; i < count; ++i) {
    const problems::Design& design = result.designs[i];
    const auto span = motion_span(design);
    if (!span || !design.layers) continue;
    LinkageScene scene{.round = span->round, .beyond = !span->round, .layers = sizes};
    scene.problem.mechanism = design.mechanism;
    scene.problem.drive.start = span->from;
    scene.problem.drive.end = span->to;
    data["designs"][i]["bill"] = bill_for_page(scene);
  }
}

}  // namespace cognate::app
