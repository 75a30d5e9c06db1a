#include "app/report/gear_report_data.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "analysis/gear/line_of_action.hpp"
#include "analysis/gear/spur_gear.hpp"
#include "analysis/gear/tooth_outline.hpp"
#include "analysis/numbers/constants.hpp"
#include "app/report/drawn_number.hpp"
#include "app/report/quantity_json.hpp"
#include "problems/basics/names.hpp"
#include "problems/gear/pair_design.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;

/// How far chords may leave the curve, in modules, so that a page of `designs` designs stays small.
double gear_fineness(std::size_t designs) {
  constexpr double kFine = 2e-4, kCoarse = 1e-3;
  constexpr std::size_t kMany = 40;
  return designs <= kMany ? kFine : kCoarse;
}

void add_half(const std::vector<gear::OutlinePoint>& half, ordered_json& gear) {
  ordered_json x = ordered_json::array(), y = x, part = x;
  for (const auto& point : half) {
    x.push_back(drawn(point.at.x));
    y.push_back(drawn(point.at.y));
    part.push_back(static_cast<int>(point.part));
  }
  gear["half"] = {{"x", x}, {"y", y}, {"part", part}};
}

/// A gear by its transverse section: `teeth`, `module`, radii (`reference`, `base`, `tip`, `root`,
/// `form`), `half_angle` (of the tooth at the base circle, rad), `pressure_angle` (rad) and `half`:
/// half a tooth by `x`, `y` and `part` (root, fillet, involute, tip by number, of the chord that
/// leads to the point), empty where the gear cannot be made.
ordered_json gear_json(const gear::SpurGear& gear, double fineness) {
  const auto half = gear::tooth_half(gear, fineness * gear.module);
  ordered_json entry = {
      {"teeth", drawn(gear.teeth)},
      {"module", drawn(gear.module)},
      {"reference", drawn(gear::reference_radius(gear))},
      {"base", drawn(gear::base_radius(gear))},
      {"tip", drawn(gear::tip_radius(gear))},
      {"root", drawn(gear::root_radius(gear))},
      {"form", half.empty() ? ordered_json(nullptr) : drawn(gear::form_radius(gear))},
      {"half_angle", drawn(gear::base_half_angle(gear))},
      {"pressure_angle", drawn(gear.rack.pressure_angle)}};
  add_half(half, entry);
  return entry;
}

/// A ring likewise, with `is_ring`; `half_angle` is from its tooth's middle to where the flank that
/// a pinion drives would begin on the base circle.
ordered_json ring_json(const gear::RingGear& ring, double fineness) {
  const bool is_made = gear::ring_fault(ring) == gear::RingFault::none;
  ordered_json entry = {
      {"is_ring", true},
      {"teeth", drawn(ring.twin.teeth)},
      {"module", drawn(ring.twin.module)},
      {"reference", drawn(gear::reference_radius(ring.twin))},
      {"base", drawn(gear::base_radius(ring.twin))},
      {"tip", drawn(gear::tip_radius(ring))},
      {"root", drawn(gear::root_radius(ring))},
      {"form", is_made ? drawn(gear::form_radius(ring)) : ordered_json(nullptr)},
      {"half_angle", drawn(gear::base_half_angle(ring.twin) - kPi / ring.twin.teeth)},
      {"pressure_angle", drawn(ring.twin.rack.pressure_angle)}};
  add_half(gear::ring_half(ring, fineness * ring.twin.module), entry);
  return entry;
}

/// One tooth of the rack that cuts `gear`, from the middle of one tooth to that of the next, as it
/// stands above the gear's upright tooth: `x`, `y`.
ordered_json rack_json(const gear::SpurGear& gear, double fineness) {
  const double half_pitch = kRightAngle * gear.module;
  ordered_json x = ordered_json::array(), y = x;
  double last = -half_pitch;
  for (const auto& at : gear::rack_outline(gear, 0, 1, fineness * gear.module)) {
    if (at.x <= last || at.x >= half_pitch) continue;
    last = at.x;
    x.push_back(drawn(at.x));
    y.push_back(drawn(at.y));
  }
  return {{"x", x}, {"y", y}};
}

using nlohmann::ordered_json;
using problems::Gearing;
using problems::GearPairDesign;

constexpr std::size_t kFlankRows = 2000;  // that a table on a page holds at most

ordered_json columns_json(const std::vector<problems::Column>& columns) {
  ordered_json list = ordered_json::array();
  for (const auto& column : columns) {
    ordered_json values = ordered_json::array();
    for (std::size_t i = 0; i < std::min(kFlankRows, column.values.size()); ++i) {
      values.push_back(drawn(column.values[i]));
    }
    list.push_back({{"name", column.name}, {"values", values}});
  }
  return list;
}

/// Both gears, and how they touch where they do.
ordered_json pair_json(const gear::SpurPair& pair, double fineness) {
  ordered_json entry = {{"gears", ordered_json::array()},
                        {"centre_distance", drawn(pair.centre_distance)}};
  bool can_be_made = true;
  for (const auto& gear : pair.gears) {
    entry["gears"].push_back(gear_json(gear, fineness));
    can_be_made = can_be_made && gear::tooth_fault(gear) == gear::ToothFault::none;
  }
  entry["working_angle"] = drawn(gear::working_pressure_angle(pair));
  if (!can_be_made || entry["working_angle"].is_null()) return entry;
  const auto line = gear::line_of_action(pair);
  entry["path_start"] = drawn(line.start);
  entry["path_end"] = drawn(line.end);
  const auto contact = gear::geometry(pair);
  for (std::size_t i = 0; i < 2; ++i) {
    entry["gears"][i]["working"] = drawn(contact.gears[i].working_radius);
  }
  return entry;
}

ordered_json cones_json(const problems::GearPairProblem& settled) {
  const gear::BevelPair pair = problems::bevel_pair(settled);
  ordered_json gears = ordered_json::array();
  double distance = 0;
  for (const int i : {0, 1}) {
    const gear::BevelGear gear = gear::bevel_gear(pair, i);
    distance = gear.cone_distance;
    gears.push_back({{"cone_angle", drawn(gear.cone_angle)},
                     {"tip_angle", drawn(gear.tip_angle)},
                     {"root_angle", drawn(gear.root_angle)}});
  }
  return {{"shaft_angle", drawn(pair.shaft_angle)},
          {"cone_distance", drawn(distance)},
          {"face_width", drawn(pair.face_width)},
          {"gears", gears}};
}

/// The wheel by its middle plane, and the worm that stands above it.
ordered_json worm_json(const gear::WormPair& pair, double fineness) {
  const gear::WormGeometry geometry = gear::geometry(pair);
  const gear::SpurGear wheel{.teeth = pair.wheel_teeth,
                             .module = pair.module,
                             .profile_shift = pair.wheel_shift,
                             .rack = pair.rack};
  const ordered_json section = {{"starts", drawn(pair.starts)},
                                {"module", drawn(pair.module)},
                                {"reference", drawn(geometry.worm_reference_diameter / 2)},
                                {"tip", drawn(geometry.worm_tip_diameter / 2)},
                                {"root", drawn(geometry.worm_root_diameter / 2)},
                                {"pressure_angle", drawn(pair.rack.pressure_angle)},
                                {"centre_distance", drawn(geometry.centre_distance)}};
  return {{"gears", ordered_json::array({gear_json(wheel, fineness)})}, {"worm", section}};
}

/// A pinion and a ring, and how they touch where they do.
ordered_json internal_json(const gear::InternalPair& pair, double fineness) {
  ordered_json entry = {
      {"gears", {gear_json(pair.pinion, fineness), ring_json(pair.ring, fineness)}},
      {"centre_distance", drawn(pair.centre_distance)}};
  const double apart = gear::base_radius(pair.ring.twin) - gear::base_radius(pair.pinion);
  const bool touches = gear::tooth_fault(pair.pinion) == gear::ToothFault::none &&
                       gear::ring_fault(pair.ring) == gear::RingFault::none &&
                       pair.centre_distance > apart;
  entry["working_angle"] = touches ? drawn(std::acos(apart / pair.centre_distance)) : nullptr;
  if (!touches) return entry;
  const auto all = gear::geometry(pair);
  entry["path_start"] = drawn(all.path_start);
  entry["path_end"] = drawn(all.path_end);
  for (std::size_t i = 0; i < 2; ++i) {
    entry["gears"][i]["working"] = drawn(all.mesh.gears[i].working_radius);
  }
  return entry;
}

/// The pinion, and the rack above it as the section of a worm on one side of an axis.
ordered_json rack_pair_json(const gear::RackPair& pair, double fineness) {
  constexpr double kBody = 2;  // from the roots to the axis, in modules
  const auto& pinion = pair.pinion;
  const double module = pinion.module, tip = pinion.rack.addendum - pair.tip_reduction;
  const double root = pinion.rack.addendum + pinion.rack.clearance, reference = root + kBody;
  const ordered_json section = {{"is_rack", true},
                                {"starts", drawn(pinion.teeth)},
                                {"module", drawn(module)},
                                {"reference", drawn(reference * module)},
                                {"tip", drawn((reference + tip) * module)},
                                {"root", drawn(kBody * module)},
                                {"offset", drawn(-0.5 * gear::geometry(pair).backlash)},
                                {"pressure_angle", drawn(pinion.rack.pressure_angle)},
                                {"centre_distance", drawn(pair.distance + reference * module)}};
  return {{"gears", ordered_json::array({gear_json(pinion, fineness)})}, {"worm", section}};
}

ordered_json drawn_design(const GearPairDesign& design, double fineness) {
  switch (design.settled.gearing) {
    case Gearing::worm:
      return worm_json(design.settled.worm, fineness);
    case Gearing::internal:
      return internal_json(problems::internal_pair(design.settled), fineness);
    case Gearing::rack:
      return rack_pair_json(problems::rack_pair(design.settled), fineness);
    default:
      return pair_json(design.pair, fineness);
  }
}

ordered_json design_json(const GearPairDesign& design, Gearing gearing, double fineness) {
  const auto& settled = design.settled;
  const bool is_worm = gearing == Gearing::worm;
  ordered_json entry = drawn_design(design, fineness);
  if (gearing == Gearing::bevel) entry["cones"] = cones_json(settled);
  ordered_json teeth = ordered_json::array(), shifts = teeth;
  const std::size_t toothed = gearing == Gearing::rack ? 1 : 2;
  for (std::size_t i = 0; i < toothed; ++i) {
    const double of_worm = i == 0 ? settled.worm.starts : settled.worm.wheel_teeth;
    teeth.push_back(drawn(is_worm ? of_worm : settled.teeth[i].value_or(0)));
    shifts.push_back(drawn(is_worm ? 0 : settled.profile_shift[i].value_or(0)));
  }
  entry["teeth"] = teeth;
  entry["shifts"] = shifts;
  entry["module"] = drawn(is_worm ? settled.worm.module : settled.module.value_or(0));
  entry["metrics"] = quantities_json(design.metrics);
  entry["constraints"] = constraints_json(design.constraints);
  entry["origin"] = design.origin;
  return entry;
}

}  // namespace

ordered_json gear_report_data(const problems::GearProblem& problem,
                              const problems::GearResult& result) {
  const gear::SpurGear section = gear::transverse(problem.gear);
  const double fineness = gear_fineness(1);
  ordered_json gear = gear_json(section, fineness);
  gear["rack"] = rack_json(section, fineness);
  const ordered_json design = {
      {"gears", ordered_json::array({gear})},
      {"teeth", ordered_json::array({drawn(problem.gear.normal.teeth)})},
      {"shifts", ordered_json::array({drawn(problem.gear.normal.profile_shift)})},
      {"module", drawn(problem.gear.normal.module)},
      {"metrics", quantities_json(result.metrics)}};
  return {{"kind", "gear"},
          {"gearing", problems::to_string(problem.gearing)},
          {"columns", columns_json(result.columns)},
          {"designs", ordered_json::array({design})}};
}

ordered_json gear_pair_report_data(const problems::GearPairProblem& problem,
                                   const problems::GearPairResult& result) {
  const double fineness = gear_fineness(result.designs.size());
  ordered_json designs = ordered_json::array();
  for (const auto& design : result.designs) {
    designs.push_back(design_json(design, problem.gearing, fineness));
  }
  return {{"kind", "pair"},
          {"gearing", problems::to_string(problem.gearing)},
          {"facts", quantities_json(result.quantities)},
          {"designs", designs}};
}

}  // namespace cognate::app
