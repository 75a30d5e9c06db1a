#include "problems/linkage/write_linkage.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "analysis/numbers/constants.hpp"
#include "problems/linkage/cycle/cycle_quantities.hpp"
#include "problems/linkage/error_limit.hpp"
#include "problems/linkage/keys.hpp"
#include "problems/linkage/linkage_keys.hpp"

namespace cognate::problems::reading {
namespace {

/// A limit over the turn that is infinite is one of an objective alone.
void set_limit(TableWriter& table, std::string_view key, const std::optional<double>& most) {
  if (most && *most != kInfinity) table.set(key, *most);
}

/// The axes of a link, from its far end where `share` says so.
Array written_axes(const LinkPlace& place) {
  constexpr std::array<std::array<std::string_view, 2>, 3> kEnds{
      {{"A", "B"}, {"B", "C"}, {"D", "C"}}};
  const auto link = std::min(static_cast<std::size_t>(place.link), kEnds.size() - 1);
  const auto& [near, far] = kEnds.at(link);
  return place.share == 1 ? Array{node(far), node(near)} : Array{node(near), node(far)};
}

Vec2d written_offset(const LinkPlace& place) {
  return place.share == 1 ? -place.offset : place.offset;
}

TableWriter link_writer(MovingLink link, const LinkMass& mass) {
  TableWriter table;
  if (mass.mass_per_length != 0) {
    return table.set_name("name", link).set("mass_per_length", mass.mass_per_length);
  }
  return table.set("between", written_axes(mass.centre))
      .set("mass", mass.mass)
      .set("centre", written_offset(mass.centre))
      .set("inertia", mass.moment);
}

TableWriter load_writer(const WorkingLoad& load) {
  TableWriter table;
  if (load.at.at_coupler_point) {
    table.set_name("on", MovingPoint::coupler_point);
  } else {
    table.set("on", written_axes(load.at)).set("at", written_offset(load.at));
  }
  table.set("force", load.force).set("torque", load.torque);
  if (load.sense != LoadSense::always) table.set_name("when", load.sense);
  return table;
}

bool has_objective(const Solve& solve, DesignObjective objective) {
  return std::ranges::count(solve.objectives, objective) > 0;
}

/// Whether designs must know the quantity: it is limited or an objective.
bool is_asked(const Constraints& constraints, const Solve& solve,
              const CycleDeclaration& quantity) {
  const auto& most = constraints.cycle_max[quantity.id];
  return has_objective(solve, objective_of(quantity.id)) || (most && *most != kInfinity);
}

/// What no file can leave out: the member of `constraints` that an objective is measured by.
void check_objective_members(const Constraints& constraints, const Solve& solve,
                             std::vector<std::string>& faults) {
  for (const CycleDeclaration& quantity : kCycleQuantities) {
    if (!has_objective(solve, objective_of(quantity.id))) continue;
    if (constraints.cycle_max[quantity.id]) continue;
    faults.push_back(
        fmt::format("constraints.{} is empty, but \"{}\" is an objective; expected "
                    "the greatest value allowed, infinity where there is none",
                    quantity.limit_key, quantity.key()));
  }
}

}  // namespace

TableWriter document_writer(std::string_view kind, const std::string& title,
                            std::optional<LengthUnit> length_unit) {
  TableWriter document;
  document.set("kind", kind);
  if (!title.empty()) document.set("title", title);
  return document.set_name("length_unit", length_unit);
}

TableWriter given_writer(const Given& given, std::string_view type) {
  TableWriter table;
  table.set("type", type);
  for (const LinkKey& link : kLinkKeys) table.set(link.key, given.*link.given);
  table.set_deg("frame_angle_deg", given.frame_angle);
  for (const BoundedPlaceKey& place : kPlaceKeys) table.set(place.key, given.*place.given);
  return table.set_name("assembly", given.assembly);
}

TableWriter bounds_writer(const Bounds& bounds) {
  TableWriter table;
  for (const LinkKey& link : kLinkKeys) table.set(link.key, bounds.*link.bounds);
  table.set_deg("frame_angle_deg", bounds.frame_angle);
  for (const BoundedPlaceKey& place : kPlaceKeys) table.set(place.key, bounds.*place.bounds);
  return table;
}

TableWriter constraints_writer(const Constraints& constraints) {
  TableWriter table;
  write_keys(constraints, kMobilityKeys, table).set("pivot_region", constraints.pivot_region);
  Array clearances;
  for (const Clearance& clearance : constraints.clearances) {
    TableWriter row;
    row.set_name("point", clearance.point);
    row.set(clearance.inside ? "inside" : "outside", clearance.box);
    clearances.push_back(node(row));
  }
  if (!clearances.empty()) table.set("clearance", clearances);
  for (const CycleDeclaration& quantity : kCycleQuantities) {
    set_limit(table, quantity.limit_key, constraints.cycle_max[quantity.id]);
  }
  if (constraints.error) {
    const auto& [of, most] = *constraints.error;
    table.set(to_string(of), shown_error(of, most));
  }
  return write_keys(constraints, kDefectKeys, table);
}

TableWriter solve_writer(const Solve& solve) {
  TableWriter table;
  table.set_name("solver", solve.solver);
  if (solve.starts != 0) table.set("starts", solve.starts);  // 0: designs known alone, see Run
  table.set("designs", solve.designs);
  Array objectives;
  for (const DesignObjective objective : solve.objectives) {
    objectives.push_back(node(to_string(objective)));
  }
  if (!objectives.empty()) table.set("objectives", objectives);
  if (solve.loss != synthesis::Loss::none) write_keys(solve, kLossKeys, table);
  write_keys(solve, kStoppingKeys, table);
  if (solve.robust == 1.0) {
    table.set(kRobustKeys[0].name, kRobustWorst);
  } else {
    table.set(kRobustKeys[0].name, solve.robust);
  }
  return solve.certify ? write_keys(solve, kCertificateKeys, table) : table;
}

Table operation_tables(const Constraints& constraints, const Solve& solve,
                       std::vector<std::string>& faults) {
  check_objective_members(constraints, solve, faults);
  TableWriter document;
  bool any = false, by_forces = false, by_flywheel = false, by_fluctuation = false;
  for (const CycleDeclaration& quantity : kCycleQuantities) {
    if (!is_asked(constraints, solve, quantity)) continue;
    any = true;
    by_forces |= quantity.by_forces;
    by_flywheel |= quantity.by_flywheel;
    by_fluctuation |= quantity.by_fluctuation;
  }
  if (!any) return {};
  const Operation& operation = constraints.operation;
  document.set("drive", TableWriter{}.set("speed", operation.speed));
  if (!by_forces) return document.take();
  TableWriter flywheel;
  if (by_flywheel && operation.flywheel != 0) flywheel.set("inertia", operation.flywheel);
  if (by_fluctuation && operation.fluctuation != 0)
    flywheel.set("fluctuation", operation.fluctuation);
  if (!flywheel.empty()) document.set("flywheel", flywheel);
  Array links, loads;
  for (std::size_t i = 0; i < operation.links.size(); ++i) {
    const LinkMass& mass = operation.links.at(i);
    if (mass.mass == 0 && mass.moment == 0 && mass.mass_per_length == 0) continue;
    links.push_back(node(link_writer(static_cast<MovingLink>(i), mass)));
  }
  for (const WorkingLoad& load : operation.loads) loads.push_back(node(load_writer(load)));
  if (!links.empty()) document.set("link", links);
  if (!loads.empty()) document.set("load", loads);
  return document.set("gravity", operation.gravity).take();
}

}  // namespace cognate::problems::reading
