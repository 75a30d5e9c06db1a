#include "problems/layers/read.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <string>

#include "analysis/layers/stacking.hpp"
#include "analysis/mechanism/joints.hpp"
#include "problems/layers/keys.hpp"

namespace cognate::problems::reading {
namespace {

/// Bodies that have a layer in any case: blocks and sliders may have none.
int least_links(const NamedMechanism& mechanism) {
  const auto list = joints(mechanism.mechanism).joints;
  const auto slides = std::ranges::count(list, JointType::prismatic, &Joint::type);
  return static_cast<int>(mechanism.bodies.size()) - 1 - static_cast<int>(slides);
}

void read_widths(TableReader& table, const NamedMechanism& mechanism, LayerSizes& sizes) {
  if (!table.has(kLinkWidths)) return;
  TableReader widths = table.table(kLinkWidths);
  for (std::size_t body = 1; body < mechanism.bodies.size(); ++body) {
    const std::string& name = mechanism.bodies[body];
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

}  // namespace

std::optional<LayerSizes> read_layers(TableReader& document, const NamedMechanism& mechanism) {
  if (!document.has(kLayersTable)) return std::nullopt;
  TableReader table = document.table(kLayersTable);
  LayerSizes sizes;
  read_keys(table, kLayerKeys, sizes);
  for (const std::string_view needed : {"link_width", "pin_diameter"}) {
    if (!table.has(needed)) table.fault(needed, "is missing; expected a length");
  }
  read_widths(table, mechanism, sizes);
  check_pins(table, sizes);
  if (const int links = least_links(mechanism); links > kMostStackedLinks) {
    table.faults().add(table.where(),
                       fmt::format("[layers] is given for {} links; at most {} can be layered",
                                   links, kMostStackedLinks));
  }
  table.finish();
  return sizes;
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
