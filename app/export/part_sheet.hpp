/// @file Parts in layers, and laid side by side on a sheet.
#pragma once

#include <string>
#include <vector>

#include "app/drawing/plan.hpp"
#include "app/export/link_parts.hpp"

namespace cognate::app {

struct PartLayers {
  std::vector<int> layers;  ///< of each part, from 1
  int count = 0;            ///< how many there are
  std::vector<std::string> notes;
};

/// The fewest layers in which parts that overlap anywhere on the way of the drive lie in different
/// ones, and no pin that goes through a layer meets another part there: found by trying layers part
/// by part, with positions at samples of the drive. Where that takes too many trials, or there is
/// no such stack, a note says so, and the parts alone are kept apart.
PartLayers part_layers(const LinkShapes& shown, const LinkParts& made, const PartOrder& order);

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
