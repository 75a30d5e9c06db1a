/// @file Bosses on plates, which fill the layers that a pin crosses.
#pragma once

#include <cstddef>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "app/export/parts/part_bill.hpp"

namespace cognate::app {

/// A boss about the hole of a plate: it fills the layers between the plate's and `next`.
struct PartBoss {
  std::size_t part = 0;  ///< index of the plate
  std::string pin;
  int next = 0;  ///< the layer of the next plate on the pin, above or below
};

struct PartBosses {
  std::vector<PartBoss> all;
  std::vector<std::string> notes;  ///< pins that cross layers and run in slots on both sides
};

/// Bosses of the diameter `order.boss`, none without: in each gap on the lower plate, or on the
/// upper one where the pin runs in a slot of the lower. The error says that the diameter is too
/// small or too large for the plates, or that bosses would meet other parts on the motion, and
/// what is allowed.
tl::expected<PartBosses, std::string> part_bosses(const PartMotion& moving, const LinkParts& made,
                                                  const PartLayers& layers, const PartOrder& order);

}  // namespace cognate::app
