#include "app/export/parts/part_blocks.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "analysis/layers/collisions.hpp"

namespace cognate::app {
namespace {

std::vector<PlatePair> pairs_of_one_bearer(const LinkParts& made, const std::vector<Plate>& plates,
                                           std::vector<std::string>& names) {
  std::vector<PlatePair> pairs;
  for (std::size_t i = 0; i < plates.size(); ++i) {
    for (std::size_t k = i + 1; k < plates.size(); ++k) {
      if (made.blocks[i].bearer != made.blocks[k].bearer) continue;
      pairs.push_back({&plates[i], &plates[k]});
      names.push_back(fmt::format("{} and {}", made.blocks[i].part.name, made.blocks[k].part.name));
    }
  }
  return pairs;
}

}  // namespace

std::optional<std::string> impossible_block(const PartOrder& order) {
  if (!order.block) return std::nullopt;
  const auto [length, width] = *order.block;
  if (width <= order.hole) {
    return fmt::format(
        "--block: the width {:.6g} leaves nothing about a hole of {:.6g}; allowed is more than "
        "that",
        width, order.hole);
  }
  if (length < width) {
    return fmt::format(
        "--block: {:.6g} long and {:.6g} wide it would turn in its slot; allowed is a length no "
        "less than the width",
        length, width);
  }
  if (width + order.clearance >= order.narrowest()) {
    return fmt::format(
        "--block: the width {:.6g} makes slots as wide as the bars; allowed is less than {:.6g}",
        width, order.narrowest() - order.clearance);
  }
  return std::nullopt;
}

LinkPart block_part(int link, const LinkShape& slider, const PartOrder& order) {
  const Vec2d half = 0.5 * *order.block;
  const LinkPlace pin = slider.places.empty() ? LinkPlace{} : slider.places.front();
  LinkPart part{.link = link, .name = slider.name};
  part.holes.push_back({pin.name, pin.at, true, order.hole});
  part.hull = {pin.at - half, pin.at + Vec2d{half.x, -half.y}, pin.at + half,
               pin.at + Vec2d{-half.x, half.y}};
  return part;
}

void note_blocks(LinkParts& made, const PartOrder& order) {
  if (!order.block) return;
  if (made.blocks.empty()) {
    made.notes.emplace_back("--block: no slider of this linkage is a pin in a slot");
    return;
  }
  const double wall = 0.5 * (order.block->y - order.hole);
  if (!is_thin(wall, order)) return;
  made.notes.push_back(
      fmt::format("the walls of blocks beside their holes are {:.3g} thick, less than a tenth of "
                  "the hole: they may break",
                  wall));
}

std::optional<std::string> blocks_meet(const PartMotion& moving, const LinkParts& made,
                                       const PartOrder& order) {
  std::vector<Plate> plates;
  for (const SlidingBlock& block : made.blocks) {
    plates.push_back({block.part.link, block.part.hull, 0});
  }
  std::vector<std::string> names;
  const auto pairs = pairs_of_one_bearer(made, plates, names);
  const Collisions found =
      find_collisions(moving.mechanism, moving.motion, pairs, order.apart, moving.stop);
  if (!found.complete) {
    return "--time-limit: came before it was known whether blocks meet; allowed is more time";
  }
  const auto met = std::ranges::find_if(
      found.pairs, [](const auto& pair) { return pair.passage != Passage::free; });
  if (met == found.pairs.end()) return std::nullopt;
  return fmt::format("--block: {} would meet in the slots of one part; allowed are shorter blocks",
                     names[static_cast<std::size_t>(met - found.pairs.begin())]);
}

void add_block_parts(LinkParts& made, PartLayers& layers) {
  for (const SlidingBlock& block : made.blocks) {
    made.parts.push_back(block.part);
    layers.layers.push_back(layers.layers[block.bearer]);
  }
}

}  // namespace cognate::app
