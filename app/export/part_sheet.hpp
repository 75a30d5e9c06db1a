/// @file Parts laid side by side on a sheet.
#pragma once

#include <vector>

#include "app/drawing/plan.hpp"
#include "app/export/link_parts.hpp"
#include "app/export/part_layers.hpp"

namespace cognate::app {

/// Where a part lies on the sheet: its own point p at `at` + `direction`·p.
struct PartPlace {
  Vec2d at{};
  Vec2d direction{1, 0};
};

struct PartSheet {
  std::vector<PartPlace> places;  ///< of each part
  Plan plan;
};

/// The parts each turned so that its longest side lies along x, in rows, at least the gap apart:
/// outlines on the layer OUTLINES, holes on HOLES, slots on SLOTS, and on LABELS the name of each
/// with its layer, on the part where it has room for it, else below.
PartSheet part_sheet(const LinkParts& made, const PartLayers& layers, const PartOrder& order);

/// A point of a part on the sheet.
Vec2d on_sheet(const PartPlace& place, const Vec2d& at);

}  // namespace cognate::app
