#include <algorithm>
#include <cmath>

#include "app/documents/problem_tables.hpp"
#include "app/kinds/gear/kind.hpp"
#include "problems/basics/names.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;
using problems::Gearing;
using problems::GearPairProblem;
using problems::GearProblem;
using problems::to_string;

ordered_json rack(const gear::BasicRack& given) {
  ordered_json table = {{"pressure_angle_deg", problems::degrees(given.pressure_angle)},
                        {"addendum", given.addendum},
                        {"clearance", given.clearance}};
  set(table, "tip_radius", given.corner_radius);
  return table;
}

void set_positive(ordered_json& table, const char* key, double value) {
  if (value > 0) table[key] = value;
}

void add_shifts(const GearPairProblem& problem, ordered_json& table) {
  const auto& [first, second] = problem.profile_shift;
  if (!first && !second) return;
  const auto written = [](const std::optional<double>& shift) {
    return shift ? ordered_json(*shift) : ordered_json("free");
  };
  table["profile_shift"] = ordered_json::array({written(first), written(second)});
}

void add_cylindrical(const GearPairProblem& problem, ordered_json& table) {
  add_shifts(problem, table);
  set(table, "centre_distance", problem.centre_distance);
  set(table, "backlash", problem.backlash);
  if (problem.gearing == Gearing::helical) table["helix_deg"] = problems::degrees(problem.helix);
  set_positive(table, "face_width", problem.face_width);
  table["tip_reduction"] = problem.tip_reduction;
}

void add_worm(const GearPairProblem& problem, ordered_json& table) {
  table["starts"] = static_cast<int>(problem.worm.starts);
  table["wheel_teeth"] = static_cast<int>(problem.worm.wheel_teeth);
  table["diameter_quotient"] = problem.worm.diameter_quotient;
  table["wheel_shift"] = problem.worm.wheel_shift;
  set(table, "friction", problem.friction);
}

ordered_json mechanism(const GearPairProblem& problem) {
  ordered_json table = {{"gearing", to_string(problem.gearing)}};
  const auto& [first, second] = problem.teeth;
  if (first && second) table["teeth"] = {*first, *second};
  set(table, "module", problem.module);
  switch (problem.gearing) {
    case Gearing::spur:
    case Gearing::helical:
      add_cylindrical(problem, table);
      break;
    case Gearing::bevel:
      add_shifts(problem, table);
      table["shaft_angle_deg"] = problems::degrees(problem.shaft_angle);
      set_positive(table, "face_width", problem.face_width);
      break;
    case Gearing::worm:
      add_worm(problem, table);
      break;
  }
  return table;
}

/// Bounds of shifts say something only of those that are free; a given one may lie outside them.
bool bounds_shifts(const GearPairProblem& problem) {
  const auto& [min, max] = problem.profile_shift_bounds;
  const bool outside = std::ranges::any_of(problem.profile_shift, [&](const auto& shift) {
    return shift && (*shift < min || *shift > max);
  });
  return !outside && !(problem.profile_shift[0] && problem.profile_shift[1]);
}

ordered_json bounds(const GearPairProblem& problem) {
  ordered_json table = ordered_json::object();
  if (!problem.teeth[0]) table["teeth"] = problem.teeth_bounds;
  if (!problem.module) table["modules"] = problem.modules;
  if (bounds_shifts(problem)) table["profile_shift"] = to_json(problem.profile_shift_bounds);
  const auto& distances = problem.centre_distance_bounds;
  const bool bounded = distances.min > 0 || std::isfinite(distances.max);
  if (!problem.centre_distance && bounded) table["centre_distance"] = to_json(distances);
  return table;
}

ordered_json constraints(const GearPairProblem& problem) {
  const problems::GearConstraints& given = problem.constraints;
  ordered_json table = ordered_json::object();
  if (problem.gearing != Gearing::worm) {
    table["contact_ratio_min"] = given.contact_ratio_min;
    table["no_interference"] = given.no_interference;
    table["hunting"] = given.hunting;
    set(table, "sliding_max", given.sliding_max);
    set(table, "tip_clearance_min", given.tip_clearance_min);
  }
  table["tip_thickness_min"] = given.tip_thickness_min;
  table["no_undercut"] = given.no_undercut;
  return table;
}

void add_search(const GearPairProblem& problem, ordered_json& tables) {
  tables["bounds"] = bounds(problem);
  ordered_json target = ordered_json::object();
  if (problem.ratio) {
    target["ratio"] = *problem.ratio;
    target["ratio_tolerance"] = problem.ratio_tolerance;
  }
  target["objective"] = to_string(problem.objective);
  tables["target"] = target;
  tables["solve"] = {{"designs", problem.solve.designs}};
}

}  // namespace

ordered_json Kind<GearProblem>::to_json(const GearProblem& problem) {
  const gear::SpurGear& gear = problem.gear.normal;
  ordered_json tables = document("gear", problem.title);
  ordered_json mechanism = {{"gearing", to_string(problem.gearing)},
                            {"teeth", static_cast<int>(gear.teeth)},
                            {"module", gear.module},
                            {"profile_shift", gear.profile_shift}};
  if (problem.gearing == Gearing::helical) {
    mechanism["helix_deg"] = problems::degrees(problem.gear.helix);
  }
  set_positive(mechanism, "face_width", problem.gear.face_width);
  mechanism["tip_reduction"] = gear.tip_reduction;
  tables["mechanism"] = mechanism;
  tables["rack"] = rack(gear.rack);
  tables["output"] = {{"points", problem.points}};
  return tables;
}

ordered_json Kind<GearPairProblem>::to_json(const GearPairProblem& problem) {
  ordered_json tables = document("gear-pair", problem.title);
  tables["mechanism"] = mechanism(problem);
  tables["rack"] = rack(problem.rack);
  const bool searched = problem.gearing == Gearing::spur || problem.gearing == Gearing::helical;
  if (searched) add_search(problem, tables);
  tables["constraints"] = constraints(problem);
  return tables;
}

}  // namespace cognate::app
