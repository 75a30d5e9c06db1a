#include "app/documents/cycle_tables.hpp"

#include <string>

#include "app/documents/json_values.hpp"
#include "problems/basics/names.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;
using problems::to_string;

/// The axes of a link, from its far end where the file has them so.
ordered_json axes(const problems::LinkPlace& place) {
  const bool reversed = place.share == 1;
  switch (place.link) {
    case problems::MovingLink::crank:
      return reversed ? ordered_json{"B", "A"} : ordered_json{"A", "B"};
    case problems::MovingLink::coupler:
      return reversed ? ordered_json{"C", "B"} : ordered_json{"B", "C"};
    case problems::MovingLink::rocker:
      break;
  }
  return reversed ? ordered_json{"C", "D"} : ordered_json{"D", "C"};
}

ordered_json offset(const problems::LinkPlace& place) {
  return to_json(place.share == 1 ? Vec2d{} - place.offset : place.offset);
}

ordered_json link_table(problems::MovingLink link, const problems::LinkMass& mass) {
  if (mass.mass_per_length > 0) {
    return {{"name", to_string(link)}, {"mass_per_length", mass.mass_per_length}};
  }
  return {{"between", axes(mass.centre)},
          {"mass", mass.mass},
          {"centre", offset(mass.centre)},
          {"inertia", mass.moment}};
}

ordered_json load_table(const problems::WorkingLoad& load) {
  ordered_json table;
  if (load.at.at_coupler_point) {
    table["on"] = to_string(problems::MovingPoint::coupler_point);
  } else {
    table["on"] = axes(load.at);
    table["at"] = offset(load.at);
  }
  table["force"] = to_json(load.force);
  table["torque"] = load.torque;
  if (load.sense != problems::LoadSense::always) table["when"] = to_string(load.sense);
  return table;
}

}  // namespace

void add_cycle_limits(const problems::Constraints& given, ordered_json& table) {
  for (const problems::Clearance& clearance : given.clearances) {
    table["clearance"].push_back(
        {{"point", to_string(clearance.point)},
         {clearance.inside ? "inside" : "outside", to_json(clearance.box)}});
  }
  for (const problems::CycleDeclaration& quantity : problems::kCycleQuantities) {
    const auto& most = given.cycle_max[quantity.id];
    if (problems::is_limit(most)) table[std::string(quantity.limit_key)] = *most;
  }
}

void add_operation(const problems::Constraints& given, ordered_json& tables) {
  if (!given.cycle_max.any()) return;
  const problems::Operation& operation = given.operation;
  tables["drive"] = {{"speed", operation.speed}};
  if (!given.cycle_max.any(&problems::CycleDeclaration::by_forces)) return;
  if (operation.flywheel > 0) tables["flywheel"]["inertia"] = operation.flywheel;
  if (operation.fluctuation > 0) tables["flywheel"]["fluctuation"] = operation.fluctuation;
  for (std::size_t i = 0; i < operation.links.size(); ++i) {
    const problems::LinkMass& mass = operation.links.at(i);
    const auto link = static_cast<problems::MovingLink>(i);
    if (mass.mass > 0 || mass.moment > 0 || mass.mass_per_length > 0) {
      tables["link"].push_back(link_table(link, mass));
    }
  }
  for (const problems::WorkingLoad& load : operation.loads) {
    tables["load"].push_back(load_table(load));
  }
  tables["gravity"] = to_json(operation.gravity);
}

}  // namespace cognate::app
