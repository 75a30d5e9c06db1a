/// A gear or a pair of gears written down, and checked by reading what was written.
#include <algorithm>
#include <cmath>

#include "problems/gear/keys.hpp"
#include "problems/gear/problem.hpp"
#include "problems/gear/read.hpp"
#include "problems/gear/result.hpp"
#include "problems/linkage/write_linkage.hpp"

namespace cognate::problems {
namespace reading {
namespace {

/// Numbers of teeth are whole; others are written for the reader to refuse.
Node count_node(double teeth) {
  const bool is_whole = std::abs(teeth) <= kMostTeeth && teeth == std::round(teeth);
  return is_whole ? node(static_cast<int>(teeth)) : node(teeth);
}

TableWriter rack_writer(const gear::BasicRack& rack) {
  TableWriter table;
  return write_keys(rack, kRackKeys, table);
}

void set_unless_zero(TableWriter& table, std::string_view key, double value) {
  if (value != 0) table.set(key, value);
}

void write_shifts(const GearPairProblem& problem, TableWriter& table) {
  const auto& [first, second] = problem.profile_shift;
  if (!first && !second) return;
  const auto shift = [](const std::optional<double>& x) { return x ? node(*x) : node("free"); };
  table.set("profile_shift", Array{shift(first), shift(second)});
}

void write_cylindrical(const GearPairProblem& problem, TableWriter& table) {
  write_shifts(problem, table);
  table.set("centre_distance", problem.centre_distance).set("backlash", problem.backlash);
  if (problem.free_helix) {
    table.add("helix_deg", node("free"));
  } else if (problem.gearing == Gearing::helical) {
    table.set_deg("helix_deg", problem.helix);
  }
  set_unless_zero(table, "face_width", problem.face_width);
  table.set("tip_reduction", problem.tip_reduction);
}

void write_worm(const GearPairProblem& problem, TableWriter& table) {
  table.add("starts", count_node(problem.worm.starts))
      .add("wheel_teeth", count_node(problem.worm.wheel_teeth))
      .set("diameter_quotient", problem.worm.diameter_quotient)
      .set("wheel_shift", problem.worm.wheel_shift)
      .set("friction", problem.friction);
}

void write_internal(const GearPairProblem& problem, TableWriter& table) {
  write_shifts(problem, table);
  table.set("centre_distance", problem.centre_distance)
      .set("backlash", problem.backlash)
      .set("tip_reduction", problem.tip_reduction)
      .set("cutter_teeth", problem.cutter_teeth);
}

void write_rack_pair(const GearPairProblem& problem, TableWriter& table) {
  table.set("pinion_teeth", problem.teeth[0])
      .set("pinion_shift", problem.profile_shift[0])
      .set("rack_distance", problem.centre_distance)
      .set("backlash", problem.backlash)
      .set("tip_reduction", problem.tip_reduction);
}

TableWriter pair_writer(const GearPairProblem& problem) {
  TableWriter table;
  table.set_name("gearing", problem.gearing);
  Array teeth;
  for (const auto& count : problem.teeth) {
    if (count) teeth.push_back(node(*count));
  }
  if (!teeth.empty() && problem.gearing != Gearing::rack) table.set("teeth", teeth);
  table.set("module", problem.module);
  switch (problem.gearing) {
    case Gearing::spur:
    case Gearing::helical:
      write_cylindrical(problem, table);
      break;
    case Gearing::internal:
      write_internal(problem, table);
      break;
    case Gearing::rack:
      write_rack_pair(problem, table);
      break;
    case Gearing::bevel:
      write_shifts(problem, table);
      table.set_deg("shaft_angle_deg", problem.shaft_angle);
      set_unless_zero(table, "face_width", problem.face_width);
      break;
    case Gearing::worm:
      write_worm(problem, table);
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

TableWriter pair_bounds_writer(const GearPairProblem& problem) {
  TableWriter table;
  const bool free_teeth = !problem.teeth[0] && !problem.teeth[1];
  const bool bounded_teeth = problem.teeth_bounds != decltype(problem.teeth_bounds){};
  if (free_teeth && bounded_teeth) table.set("teeth", problem.teeth_bounds);
  if (!problem.module && !problem.modules.empty()) table.set("modules", problem.modules);
  if (bounds_shifts(problem)) table.set("profile_shift", problem.profile_shift_bounds);
  const auto& distances = problem.centre_distance_bounds;
  const bool bounded = distances.min != 0 || distances.max != kInfinity;
  if (!problem.centre_distance && bounded) table.set("centre_distance", distances);
  return table;
}

TableWriter pair_constraints_writer(const GearPairProblem& problem) {
  const GearConstraints& given = problem.constraints;
  TableWriter table;
  if (problem.gearing != Gearing::worm) write_keys(given, kMeshKeys, table);
  return write_keys(given, kToothKeys, table);
}

TableWriter pair_target_writer(const GearPairProblem& problem) {
  TableWriter table;
  table.set("ratio", problem.ratio);
  if (problem.ratio || problem.ratio_tolerance != 0) {
    table.set("ratio_tolerance", problem.ratio_tolerance);
  }
  return table.set_name("objective", problem.objective);
}

}  // namespace
}  // namespace reading

reading::Written KindTraits<GearProblem>::written(const GearProblem& problem) {
  using namespace reading;
  const gear::SpurGear& gear = problem.gear.normal;
  TableWriter mechanism;
  mechanism.set_name("gearing", problem.gearing)
      .add("teeth", count_node(gear.teeth))
      .set("module", gear.module)
      .set("profile_shift", gear.profile_shift);
  if (problem.gearing == Gearing::helical || problem.gear.helix != 0) {
    mechanism.set_deg("helix_deg", problem.gear.helix);
  }
  set_unless_zero(mechanism, "face_width", problem.gear.face_width);
  mechanism.set("tip_reduction", gear.tip_reduction);
  TableWriter output;
  output.set("points", problem.points).set("span_teeth", problem.span_teeth);
  return {document_writer(kWord, problem.title, problem.length_unit)
              .set("mechanism", mechanism)
              .set("rack", rack_writer(gear.rack))
              .set("output", output)
              .take(),
          {}};
}

reading::Written KindTraits<GearPairProblem>::written(const GearPairProblem& problem) {
  using namespace reading;
  TableWriter document = document_writer(kWord, problem.title, problem.length_unit);
  document.set("mechanism", pair_writer(problem)).set("rack", rack_writer(problem.rack));
  if (is_searched(problem.gearing)) {
    document.set("bounds", pair_bounds_writer(problem))
        .set("target", pair_target_writer(problem))
        .set("solve", TableWriter{}.set("designs", problem.solve.designs));
  }
  return {document.set("constraints", pair_constraints_writer(problem)).take(), {}};
}

tl::expected<GearProblem, std::vector<std::string>> KindTraits<GearProblem>::checked(
    const GearProblem& problem) {
  return reading::read_back(problem).map([&](const auto&) { return problem; });
}

tl::expected<GearPairProblem, std::vector<std::string>> KindTraits<GearPairProblem>::checked(
    const GearPairProblem& problem) {
  const auto read = reading::read_back(problem);
  if (!read) return tl::unexpected(read.error());
  GearPairProblem whole = problem;
  whole.modules = read->modules;  // in order, each once
  whole.helix = problem.free_helix ? read->helix : problem.helix;
  if (!is_searched(problem.gearing)) whole.profile_shift = read->profile_shift;
  if (problem.gearing != Gearing::worm) return whole;
  whole.worm.module = read->worm.module;
  whole.worm.rack = problem.rack;
  return whole;
}

}  // namespace cognate::problems
