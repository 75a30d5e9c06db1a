#include "app/documents/layers_json.hpp"

#include <string>

#include "problems/basics/degrees.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;
using problems::LayerConflict;
using problems::LayerConflictKind;
using problems::LayerResult;

const char* word_of(LayerConflictKind kind) {
  switch (kind) {
    case LayerConflictKind::joint:
      return "joint";
    case LayerConflictKind::slide:
      return "slide";
    case LayerConflictKind::collision:
      return "collision";
    case LayerConflictKind::unresolved:
      break;
  }
  return "unresolved";
}

ordered_json conflict_json(const LayerConflict& conflict, bool drive_slides) {
  ordered_json links = ordered_json::array(), pins = ordered_json::array();
  (conflict.first_is_pin ? pins : links).push_back(conflict.first);
  (conflict.second_is_pin ? pins : links).push_back(conflict.second);
  ordered_json entry = {{"links", links}, {"pins", pins}, {"why", word_of(conflict.kind)}};
  if (conflict.drive) {
    entry[drive_slides ? "first_at" : "first_at_deg"] =
        drive_slides ? *conflict.drive : problems::degrees(*conflict.drive);
  }
  return entry;
}

}  // namespace

ordered_json layers_json(const LayerResult& result, bool drive_slides) {
  ordered_json links = ordered_json::array(), pins = ordered_json::array();
  for (const auto& link : result.links) {
    links.push_back({{"name", link.name},
                     {"layer", link.layer > 0 ? ordered_json(link.layer) : ordered_json(nullptr)},
                     {"width", link.width}});
  }
  for (const auto& pin : result.pins) {
    pins.push_back({{"name", pin.name}, {"joins", pin.joins}, {"crosses", pin.crosses}});
  }
  ordered_json conflicts = ordered_json::array();
  for (const auto& conflict : result.conflicts) {
    conflicts.push_back(conflict_json(conflict, drive_slides));
  }
  return {{"count", result.count ? ordered_json(*result.count) : ordered_json(nullptr)},
          {"proof", "exhaustive"},
          {"links", links},
          {"pins", pins},
          {"conflicts", conflicts},
          {"blocked", result.blocked},
          {"layers_tried", result.tried},
          {"drive_cells", result.cells}};
}

}  // namespace cognate::app
