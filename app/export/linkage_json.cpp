#include "app/export/linkage_json.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/documents/json_values.hpp"
#include "problems/basics/names.hpp"
#include "problems/mechanism/dimensions.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;

ordered_json link_json(const LinkShapes& shown, const LinkShape& link) {
  ordered_json places = ordered_json::array(), lengths = places, slots = places;
  for (std::size_t i = 0; i < link.places.size(); ++i) {
    const LinkPlace& place = link.places[i];
    places.push_back({{"name", place.name}, {"at", to_json(place.at)}, {"joint", place.joint}});
    for (std::size_t k = i + 1; k < link.places.size(); ++k) {
      lengths.push_back({{"from", place.name},
                         {"to", link.places[k].name},
                         {"length", norm(link.places[k].at - place.at)}});
    }
  }
  for (const Rail& rail : link.shape.rails) {
    slots.push_back({{"slider", shown.links[static_cast<std::size_t>(rail.traveller)].name},
                     {"from", to_json(rail.from)},
                     {"to", to_json(rail.to)}});
  }
  ordered_json table = {
      {"name", link.name}, {"places", places}, {"lengths", lengths}, {"slots", slots}};
  if (link.layer > 0) table["layer"] = link.layer;
  return table;
}

ordered_json joint_json(const LinkShapes& shown, const JointShape& joint) {
  const auto name = [&](int link) { return shown.links[static_cast<std::size_t>(link)].name; };
  return {{"name", joint.name},
          {"type", joint.type == JointType::revolute ? "turning" : "sliding"},
          {"links", {name(joint.first), name(joint.second)}}};
}

/// Where every place is, each once.
ordered_json places_json(const LinkShapes& shown, std::span<const BodyMotion<double, 0>> bodies) {
  ordered_json places = ordered_json::object();
  for (std::size_t i = 0; i < shown.links.size(); ++i) {
    for (const LinkPlace& place : shown.links[i].places) {
      if (places.contains(place.name)) continue;
      places[place.name] = to_json(point_motion(bodies[i], place.at)[0]);
    }
  }
  return places;
}

ordered_json path_json(const PointPath& path) {
  ordered_json corners = ordered_json::array();
  for (const Vec2d& corner : path.corners) corners.push_back(to_json(corner));
  return {{"point", path.point}, {"closed", path.closed}, {"corners", corners}};
}

ordered_json part_json(const PartOptions& told, std::size_t i) {
  const LinkPart& part = told.made.parts[i];
  const PartPlace& place = told.sheet.places[i];
  ordered_json holes = ordered_json::array(), slots = holes;
  for (const PartHole& hole : part.holes) {
    holes.push_back({{"name", hole.name},
                     {"at", to_json(on_sheet(place, hole.at))},
                     {"diameter", hole.diameter}});
  }
  for (const PartSlot& slot : part.slots) {
    slots.push_back({{"slider", slot.name},
                     {"from", to_json(on_sheet(place, slot.from))},
                     {"to", to_json(on_sheet(place, slot.to))},
                     {"width", slot.width}});
  }
  ordered_json table = {
      {"name", part.name}, {"plane", told.layers.layers[i]}, {"holes", holes}, {"slots", slots}};
  if (told.order.sheet) table["sheet"] = place.sheet;
  return table;
}

ordered_json pin_json(const PartOptions& told, const PartPin& pin) {
  ordered_json names = ordered_json::array();
  for (const int part : pin.parts) {
    names.push_back(told.made.parts[static_cast<std::size_t>(part)].name);
  }
  const PinStack stack = pin_stack(pin, told.layers);
  ordered_json table = {{"name", pin.name}, {"parts", names}, {"planes", {stack.low, stack.high}}};
  if (const auto length = stack_height(stack.high - stack.low + 1, told.order)) {
    table["length"] = *length;
  }
  return table;
}

}  // namespace

ordered_json linkage_json(const LinkageScene& linkage, const LinkShapes& shown,
                          std::span<const BodyMotion<double, 0>> bodies, double drive,
                          const std::vector<PointPath>& paths) {
  const auto& mechanism = linkage.problem.mechanism;
  ordered_json document = {{"type", problems::to_string(mechanism.type())},
                           {"dimensions", ordered_json::object()}};
  if (const auto unit = linkage.problem.length_unit) document["length_unit"] = to_string(*unit);
  for (const auto& dimension : main_dimensions(mechanism)) {
    document["dimensions"][dimension.name] = dimension.value;
  }
  for (const char* list : {"links", "joints", "paths"}) document[list] = ordered_json::array();
  for (const auto& link : shown.links) document["links"].push_back(link_json(shown, link));
  for (const auto& joint : shown.joints) document["joints"].push_back(joint_json(shown, joint));
  for (const auto& path : paths) document["paths"].push_back(path_json(path));
  document["position"] = {{is_driven_by_slider(linkage) ? "slide" : "crank_deg", drive},
                          {"places", places_json(shown, bodies)}};
  return document;
}

ordered_json columns_json(const std::vector<problems::Column>& columns) {
  ordered_json list = ordered_json::array();
  for (const auto& column : columns) {
    ordered_json values = ordered_json::array();
    for (const double value : column.values) {
      values.push_back(std::isfinite(value) ? ordered_json(value) : nullptr);
    }
    list.push_back({{"name", column.name}, {"unit", column.unit}, {"values", values}});
  }
  return list;
}

ordered_json parts_json(const PartOptions& told) {
  const PartOrder& order = told.order;
  ordered_json table = {{"hole", order.hole},           {"width", order.width},
                        {"clearance", order.clearance}, {"planes", told.layers.count},
                        {"fewest", told.layers.fewest}, {"parts", ordered_json::array()},
                        {"pins", ordered_json::array()}};
  if (order.kerf > 0) table["kerf"] = order.kerf;
  if (order.bearing) table["bearing"] = order.bearing->designation;
  for (std::size_t i = 0; i < told.made.parts.size(); ++i) {
    if (!told.made.parts[i].cylinder) table["parts"].push_back(part_json(told, i));
  }
  for (const PartPin& pin : told.made.pins) table["pins"].push_back(pin_json(told, pin));
  if (const auto height = stack_height(told.layers.count, order)) {
    table["thickness"] = *order.thickness;
    table["height"] = *height;
  }
  if (order.sheet) {
    table["sheets"] = {{"width", order.sheet->x},
                       {"height", order.sheet->y},
                       {"count", told.sheet.sheets},
                       {"utilisation", told.sheet.utilisation}};
  }
  table["bill"] = bill_json(told.bill);
  return table;
}

}  // namespace cognate::app
