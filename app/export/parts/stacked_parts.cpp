#include "app/export/parts/stacked_parts.hpp"

#include <nlohmann/json.hpp>
#include <utility>

#include "analysis/mechanism/assembly_ranges.hpp"
#include "app/export/parts/part_blocks.hpp"
#include "synthesis/search/deadline.hpp"

namespace cognate::app {

tl::expected<BilledParts, std::string> stacked_parts(const Mechanism<double>& mechanism,
                                                     const LinkShapes& shown,
                                                     const PartOrder& order,
                                                     const std::function<bool()>& stop) {
  auto made = link_parts(shown, order);
  if (!made) return tl::unexpected(made.error());
  const auto& drive = shown.poses.drive;
  const AssemblyRanges motion = follow(mechanism, drive.front(), drive.back());
  const PartMotion moving{mechanism, motion, stop};
  auto layers = part_layers(moving, *made, order);
  if (!layers) return tl::unexpected(layers.error());
  PartBill bill = part_bill(moving, *made, *layers, order);
  auto bosses = part_bosses(moving, *made, *layers, order);
  if (!bosses) return tl::unexpected(bosses.error());
  if (const auto why = blocks_meet(moving, *made, order)) return tl::unexpected(*why);
  add_block_parts(*made, *layers);
  return BilledParts{*std::move(made), *std::move(layers), std::move(bill), *std::move(bosses)};
}

PartOrder part_order(const problems::LayerSizes& sizes) {
  PartOrder order;
  order.hole = sizes.pin_diameter;
  order.width = sizes.link_width;
  order.widths = sizes.widths;
  order.apart = sizes.clearance;
  order.thickness = sizes.thickness;
  return order;
}

nlohmann::ordered_json bill_for_page(const LinkageScene& linkage) {
  constexpr double kMostSeconds = 5;
  if (!linkage.layers) return nullptr;
  const synthesis::Deadline deadline(kMostSeconds);
  const auto parts = stacked_parts(linkage.problem.mechanism.mechanism, link_shapes(linkage),
                                   part_order(*linkage.layers), [&] { return deadline.reached(); });
  if (!parts) return nullptr;
  nlohmann::ordered_json notes = parts->layers.notes;
  for (const std::string& note : parts->bill.notes) notes.push_back(note);
  return {{"layers", parts->layers.count}, {"rows", bill_json(parts->bill)}, {"notes", notes}};
}

}  // namespace cognate::app
