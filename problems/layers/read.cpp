#include "problems/layers/read.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <span>
#include <string>

#include "analysis/layers/plates.hpp"
#include "analysis/layers/stacking.hpp"
#include "analysis/mechanism/joints.hpp"
#include "problems/layers/keys.hpp"
#include "problems/mechanism/driving_cylinder.hpp"

namespace cognate::problems::reading {
namespace {

/// Bodies that have a layer in any case: blocks and sliders may have none.
int least_links(const NamedMechanism& mechanism) {
  const auto list = joints(mechanism.mechanism).joints;
  const auto slides = std::ranges::count(list, JointType::prismatic, &Joint::type);
  return static_cast<int>(mechanism.bodies.size()) - 1 - static_cast<int>(slides);
}

void read_widths(TableReader& table, std::span<const std::string> links, LayerSizes& sizes) {
  if (!table.has(kLinkWidths)) return;
  TableReader widths = table.table(kLinkWidths);
  for (const std::string& name : links) {
    if (const auto width = widths.number(name, kLength)) sizes.widths.push_back({name, *width});
  }
  widths.finish();
}

/// A pin needs a hole in every link that is no wider than the link.
void check_pins(TableReader& table, const LayerSizes& sizes) {
  constexpr std::string_view kPin = "pin_diameter";
  if (!(sizes.link_width > 0 && sizes.pin_diameter > 0)) return;
  double narrowest = sizes.link_width;
  for (const LinkWidth& link : sizes.widths) narrowest = std::min(narrowest, link.width);
  if (sizes.pin_diameter <= narrowest) return;
  table.fault(kPin, fmt::format("is {:.6g}, wider than a link of {:.6g}; expected no more than "
                                "the width of every link",
                                sizes.pin_diameter, narrowest));
}

/// `least`: how many links have a layer in any case.
LayerSizes read_sizes(TableReader& document, std::span<const std::string> links, int least) {
  TableReader table = document.table(kLayersTable);
  LayerSizes sizes;
  read_keys(table, kLayerKeys, sizes);
  for (const std::string_view needed : {"link_width", "pin_diameter"}) {
    if (!table.has(needed)) table.fault(needed, "is missing; expected a length");
  }
  read_widths(table, links, sizes);
  check_pins(table, sizes);
  if (least > kMostStackedLinks) {
    table.faults().add(table.where(),
                       fmt::format("[layers] is given for {} links; at most {} can be layered",
                                   least, kMostStackedLinks));
  }
  table.finish();
  return sizes;
}

}  // namespace

std::optional<LayerSizes> read_layers(TableReader& document, const NamedMechanism& mechanism) {
  if (!document.has(kLayersTable)) return std::nullopt;
  // A rod lies in its cylinder and has no width of its own.
  const std::size_t first = has_driving_cylinder(mechanism) ? kDrivingCylinder : 1;
  return read_sizes(document, std::span(mechanism.bodies).subspan(first), least_links(mechanism));
}

std::optional<DesignLayers> read_design_layers(TableReader& document, TableReader& constraints,
                                               const LinkNames& names, std::string_view refusal) {
  DesignLayers layers;
  const std::string_view key = kLayersMaxKeys.front().name;
  read_keys(constraints, kLayersMaxKeys, layers);
  const bool has_sizes = document.has(kLayersTable);
  if (constraints.has(key) && !has_sizes) {
    constraints.fault(key,
                      "is given without [layers], which has the widths of links and pins; expected "
                      "link_width and pin_diameter there");
  } else if (constraints.has(key) && !refusal.empty()) {
    constraints.fault(key, refusal);
  }
  if (!has_sizes) return std::nullopt;
  std::vector<std::string> all;
  std::size_t most = 0;
  for (const auto& links : names) {
    most = std::max(most, links.size());
    for (const std::string& link : links) {
      if (std::ranges::find(all, link) == all.end()) all.push_back(link);
    }
  }
  layers.sizes = read_sizes(document, all, static_cast<int>(most));
  return layers;
}

void write_design_layers(const std::optional<DesignLayers>& layers, TableWriter& constraints) {
  if (layers) write_keys(*layers, kLayersMaxKeys, constraints);
}

Table layers_table(const std::optional<DesignLayers>& layers) {
  return layers ? layers_table(std::optional(layers->sizes)) : Table{};
}

Table layers_table(const std::optional<LayerSizes>& sizes) {
  if (!sizes) return {};
  TableWriter table, widths;
  write_keys(*sizes, kLayerKeys, table);
  for (const auto& [link, width] : sizes->widths) widths.set(link, width);
  if (!widths.empty()) table.add(kLinkWidths, node(widths));
  return TableWriter{}.add(kLayersTable, node(table)).take();
}

}  // namespace cognate::problems::reading
