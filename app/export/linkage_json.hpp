/// @file A linkage as one plain document.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <vector>

#include "analysis/mechanism/motion_state.hpp"
#include "app/drawing/link_shapes.hpp"
#include "app/drawing/linkage_paths.hpp"
#include "app/export/parts/part_bill.hpp"
#include "app/export/parts/part_sheet.hpp"
#include "problems/evaluation/result.hpp"

namespace cognate::app {

/// What a document says of parts.
struct PartOptions {
  const LinkParts& made;
  const PartLayers& layers;
  const PartSheet& sheet;
  const PartBill& bill;
  const PartOrder& order;
};

/// `type`; `dimensions`; `links` (name, places of their joints and points in their own axes, the
/// distances of these, slots, layer); `joints` (name, type, links); `position` (`drive`, in degrees
/// or a length, and where every place is there); `paths` (polygons).
nlohmann::ordered_json linkage_json(const LinkageScene& linkage, const LinkShapes& shown,
                                    std::span<const BodyMotion<double, 0>> bodies, double drive,
                                    const std::vector<PointPath>& paths);

/// The columns of a table: each `name`, `unit` and `values`, null where the linkage cannot be
/// assembled.
nlohmann::ordered_json columns_json(const std::vector<problems::Column>& columns);

/// `hole`, `width`, `clearance`, `kerf`, `bearing`, `parts` (name, layer, where their holes and
/// slots are on the sheet), `planes`, `pins` (name, layers that they go through; with a thickness
/// their length and the height of the stack), `sheets`, `bill`.
nlohmann::ordered_json parts_json(const PartOptions& told);

}  // namespace cognate::app
