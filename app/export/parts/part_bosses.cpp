#include "app/export/parts/part_bosses.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <optional>

namespace cognate::app {
namespace {

constexpr int kTries = 20;  // diameters from the given one down to the hole

bool has_hole(const LinkPart& part, const std::string& pin) {
  return std::ranges::find(part.holes, pin, &PartHole::name) != part.holes.end();
}

/// The parts of a pin by their layers, the lowest first.
std::vector<int> by_layer(const PartPin& pin, const PartLayers& layers) {
  std::vector<int> parts = pin.parts;
  std::ranges::sort(parts, {}, [&](int part) { return layers.layers[std::size_t(part)]; });
  return parts;
}

/// Why a boss of this diameter has no room on the plates.
std::optional<std::string> without_room(const PartOrder& order) {
  const double hole = order.bearing ? order.bearing->outside : order.hole;
  if (*order.boss > hole && *order.boss <= order.narrowest()) return std::nullopt;
  return fmt::format(
      "--boss: {:.6g} is not possible about holes of {:.6g} on links of {:.6g}; allowed is more "
      "than the hole and no more than the width",
      *order.boss, hole, order.narrowest());
}

}  // namespace

tl::expected<PartBosses, std::string> part_bosses(const PartMotion& moving, const LinkParts& made,
                                                  const PartLayers& layers,
                                                  const PartOrder& order) {
  PartBosses bosses;
  if (!order.boss) return bosses;
  if (const auto why = without_room(order)) return tl::unexpected(*why);
  for (const PartPin& pin : made.pins) {
    const auto parts = by_layer(pin, layers);
    for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
      const auto low = std::size_t(parts[i]), high = std::size_t(parts[i + 1]);
      if (layers.layers[high] - layers.layers[low] < 2) continue;
      if (has_hole(made.parts[low], pin.name)) {
        bosses.all.push_back({low, pin.name, layers.layers[high]});
      } else if (has_hole(made.parts[high], pin.name)) {
        bosses.all.push_back({high, pin.name, layers.layers[low]});
      } else {
        bosses.notes.push_back(fmt::format(
            "the pin {} runs in slots on both sides of the layers that it crosses: it has no boss",
            pin.name));
      }
    }
  }
  if (bosses.all.empty() || rings_fit(moving, made, layers, order, *order.boss)) return bosses;
  for (int i = kTries - 1; i > 0; --i) {
    const double smaller = order.hole + (*order.boss - order.hole) * i / kTries;
    if (!rings_fit(moving, made, layers, order, smaller)) continue;
    return tl::unexpected(fmt::format(
        "--boss: {:.6g} is not possible: a boss would meet another part; one of {:.6g} fits",
        *order.boss, smaller));
  }
  return tl::unexpected(
      std::string("--boss: no boss fits about the pins in the layers that they cross; expected no "
                  "--boss"));
}

}  // namespace cognate::app
