/// @file Parts laid on sheets.
#pragma once

#include <string>
#include <vector>

#include "app/drawing/plan.hpp"
#include "app/export/parts/link_parts.hpp"
#include "app/export/parts/part_layers.hpp"

namespace cognate::app {

/// Where a part lies on the sheet: its own point p at `at` + `direction`·p.
struct PartPlace {
  Vec2d at{};
  Vec2d direction{1, 0};
  int sheet = 1;  ///< counted from 1
};

struct PartSheet {
  std::vector<PartPlace> places;  ///< of each part that is cut
  int sheets = 1;
  double utilisation = 0;  ///< what share of the sheets the parts take; 0 without a sheet's size
  Plan plan;
};

/// The parts each turned so that its longest side lies along x, in rows, at least the gap apart:
/// outlines on the layer OUTLINES, holes on HOLES, slots on SLOTS, and the name of each with its
/// layer, on the part where it has room for it, else below: as text on LABELS or in strokes on
/// ENGRAVE. With a kerf outlines are larger and holes and slots smaller by half of it all around.
///
/// On sheets of a given size each part is turned so that the rectangle about it is least, or that
/// by a right angle; the sheets lie side by side, their edges on SHEETS. The error names a part
/// that is larger than the sheet.
tl::expected<PartSheet, std::string> part_sheet(const LinkParts& made, const PartLayers& layers,
                                                const PartOrder& order);

/// Width and height of the least rectangle about a finished part.
Vec2d part_size(const LinkPart& part);

/// A point of a part on the sheet.
Vec2d on_sheet(const PartPlace& place, const Vec2d& at);

}  // namespace cognate::app
