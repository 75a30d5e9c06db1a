/// @file Parts in layers.
#pragma once

#include <functional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "analysis/mechanism/assembly_ranges.hpp"
#include "analysis/mechanism/mechanism.hpp"
#include "app/export/parts/link_parts.hpp"

namespace cognate::app {

struct PartLayers {
  std::vector<int> layers;  ///< of each part, from 1
  int count = 0;            ///< how many there are
  /// Whether no fewer layers suffice with the frame below all other parts.
  bool fewest = false;
  std::vector<std::string> notes;
};

/// What moves, and how.
struct PartMotion {
  const Mechanism<double>& mechanism;
  const AssemblyRanges& motion;
  std::function<bool()> stop;
};

/// Layers in which parts that collide anywhere on the motion lie in different ones, and no pin
/// that goes through a layer meets another part or pin there. Collisions are excluded for every
/// position, as for `[layers]` of an analysis, and so is the stack: the frame is layer 1, and the
/// others lie above it in the fewest layers, found by exhaustion.
///
/// Where there is no such stack, or there are more parts than can be exhausted, layers are tried
/// part by part, the frame in any of them; where that finds none or takes too many trials, a note
/// says so, and the parts alone are kept apart. The error says that the time was up.
tl::expected<PartLayers, std::string> part_layers(const PartMotion& moving, const LinkParts& made,
                                                  const PartOrder& order);

}  // namespace cognate::app
