#include <fmt/core.h>

#include <cmath>

#include "problems/gear/keys.hpp"
#include "problems/gear/pair_helix.hpp"
#include "problems/gear/problem.hpp"
#include "problems/gear/read.hpp"
#include "problems/gear/read_pair_bounds.hpp"
#include "problems/linkage/read_constraints.hpp"
#include "problems/toml/table_reader.hpp"

namespace cognate::problems::reading {
namespace {

constexpr std::string_view kHelixAngle = "helix_deg", kPinionTeeth = "pinion_teeth",
                           kPinionShift = "pinion_shift", kRackDistance = "rack_distance",
                           kCutterTeeth = "cutter_teeth";
constexpr std::string_view kBacklashKey = "backlash", kFace = "face_width",
                           kShaft = "shaft_angle_deg", kFree = "free";

/// So many that a search of all of them ends.
constexpr int kMostDesigns = 100;

void read_teeth(TableReader& mechanism, GearPairProblem& problem) {
  const auto teeth = mechanism.two(kTeethKey, kTeeth, "[z1, z2]");
  if (!teeth) return;
  for (std::size_t i = 0; i < 2; ++i) problem.teeth[i] = static_cast<int>((*teeth)[i]);
}

// Numbers, or the word that leaves one of them to be found.
void read_shifts(TableReader& mechanism, GearPairProblem& problem) {
  std::vector<bool> is_number;
  const auto shifts =
      mechanism.each_number_or(kShift, kFree, kProfileShift, {2, 2, "numbers"}, is_number);
  for (std::size_t i = 0; i < shifts.size() && i < 2; ++i) {
    if (is_number[i]) problem.profile_shift[i] = shifts[i];
  }
}

void read_reductions(TableReader& mechanism, GearPairProblem& problem) {
  const auto reductions = mechanism.two(kReduction, kTipReduction, "[k1, k2]");
  if (reductions) problem.tip_reduction = *reductions;
}

// Backlash follows where nothing is left that could be made to give it.
void check_backlash(TableReader& mechanism, const GearPairProblem& problem) {
  const auto& [first, second] = problem.profile_shift;
  if (!problem.backlash || !problem.centre_distance || !first || !second) return;
  if (problem.free_helix) return;
  mechanism.fault(kBacklashKey,
                  "is given beside centre_distance and both values of profile_shift, from which it "
                  "follows; leave one of them out");
}

bool asks_for_helix(TableReader& mechanism, Gearing gearing) {
  return gearing == Gearing::helical && mechanism.has_text(kHelixAngle) &&
         mechanism.text(kHelixAngle) == kFree;
}

// The helix that the centre distance asks for, where all else is given.
void find_helix(TableReader& mechanism, GearPairProblem& problem) {
  std::string missing;
  for (const auto key : {kTeethKey, kModule, kShift, kDistance}) {
    if (mechanism.has(key) && !mechanism.has_word(key, kFree)) continue;
    missing += fmt::format("{}{}", missing.empty() ? "" : ", ", key);
  }
  if (!missing.empty()) {
    mechanism.fault(kHelixAngle, fmt::format("is \"free\" without {}; expected values of teeth, "
                                             "module, profile_shift ([0, 0] for none) and "
                                             "centre_distance, or an angle in degrees",
                                             missing));
    return;
  }
  const auto helix = helix_of_distance(problem);
  if (helix) {
    problem.helix = *helix;
    return;
  }
  const auto distances = distances_of_helices(problem);
  if (!distances || !problem.centre_distance) return;  // faulted before
  const auto [least, greatest] = *distances;
  if (!std::isfinite(least)) {
    mechanism.fault(kShift,
                    "makes teeth so thin that they have no centre distance without helix; "
                    "expected greater shifts");
    return;
  }
  mechanism.fault(kDistance,
                  fmt::format("is {:g}, which no helix gives; expected more than {:.8g}, "
                              "that without helix, and at most {:.8g}, that with 80 "
                              "degrees",
                              *problem.centre_distance, least, greatest));
}

void read_cylindrical(TableReader& mechanism, GearPairProblem& problem) {
  problem.free_helix = asks_for_helix(mechanism, problem.gearing);
  if (!problem.free_helix) problem.helix = read_helix(mechanism, problem.gearing);
  problem.face_width = mechanism.number(kFace, kLinkLength).value_or(0);
  read_teeth(mechanism, problem);
  problem.module = mechanism.number(kModule, kLinkLength);
  read_shifts(mechanism, problem);
  problem.centre_distance = mechanism.number(kDistance, kLinkLength);
  problem.backlash = mechanism.number(kBacklashKey, kBacklash);
  read_reductions(mechanism, problem);
  refuse_keys(mechanism,
              {kShaft, "starts", "wheel_teeth", "diameter_quotient", "wheel_shift", "friction",
               kPinionTeeth, kPinionShift, kRackDistance, kCutterTeeth},
              fmt::format("{} gears have none", to_string(problem.gearing)));
  check_backlash(mechanism, problem);
  if (problem.free_helix) find_helix(mechanism, problem);
}

// A distance and the backlash that follows from it.
void read_place(TableReader& mechanism, std::string_view key, GearPairProblem& problem) {
  problem.centre_distance = mechanism.number(key, kLinkLength);
  problem.backlash = mechanism.number(kBacklashKey, kBacklash);
  if (!mechanism.has(key) || !mechanism.has(kBacklashKey)) return;
  mechanism.fault(kBacklashKey, fmt::format("is given beside {}, from which it follows; leave one "
                                            "of them out",
                                            key));
}

void want(TableReader& mechanism, std::initializer_list<std::string_view> keys,
          std::string_view why) {
  for (const auto key : keys) {
    if (!mechanism.has(key)) mechanism.fault(key, fmt::format("is missing; {}", why));
  }
}

void read_internal(TableReader& mechanism, GearPairProblem& problem) {
  read_teeth(mechanism, problem);
  problem.module = mechanism.number(kModule, kLinkLength);
  const auto shifts = mechanism.two(kShift, kProfileShift, "[x1, x2]");
  problem.profile_shift = {shifts ? (*shifts)[0] : 0, shifts ? (*shifts)[1] : 0};
  read_place(mechanism, kDistance, problem);
  read_reductions(mechanism, problem);
  problem.cutter_teeth = static_cast<int>(
      mechanism.number(kCutterTeeth, kTeeth).value_or(GearPairProblem{}.cutter_teeth));
  want(mechanism, {kTeethKey, kModule}, "internal gears are evaluated, not searched for");
  refuse_keys(mechanism,
              {kHelixAngle, kFace, kShaft, "starts", "wheel_teeth", "diameter_quotient",
               "wheel_shift", "friction", kPinionTeeth, kPinionShift, kRackDistance},
              "internal gears have none");
  const auto& [pinion, ring] = problem.teeth;
  if (!pinion || !ring || *pinion < *ring) return;
  mechanism.fault(kTeethKey, fmt::format("gives the ring {} teeth and the pinion {}; expected "
                                         "more of the ring, [z1, z2] with z1 < z2",
                                         *ring, *pinion));
}

void read_rack_pair(TableReader& mechanism, GearPairProblem& problem) {
  const auto teeth = mechanism.number(kPinionTeeth, kTeeth);
  if (teeth) problem.teeth[0] = static_cast<int>(*teeth);
  problem.module = mechanism.number(kModule, kLinkLength);
  problem.profile_shift = {mechanism.number(kPinionShift, kProfileShift).value_or(0), 0};
  read_place(mechanism, kRackDistance, problem);
  read_reductions(mechanism, problem);
  want(mechanism, {kPinionTeeth, kModule}, "a rack and its pinion are evaluated, not searched for");
  refuse_keys(mechanism, {kTeethKey}, "a rack has no number of them; its pinion has pinion_teeth");
  refuse_keys(mechanism, {kShift}, "the pinion alone is shifted, by pinion_shift");
  refuse_keys(mechanism, {kDistance}, "a rack has no centre; expected rack_distance");
  refuse_keys(mechanism,
              {kHelixAngle, kFace, kShaft, "starts", "wheel_teeth", "diameter_quotient",
               "wheel_shift", "friction", kCutterTeeth},
              "a rack and its pinion have none");
}

// The cones are those of the teeth: shifts that do not add up to 0 would need others.
void check_bevel_shifts(TableReader& mechanism, const GearPairProblem& problem) {
  const double first = problem.profile_shift[0].value_or(0);
  const double second = problem.profile_shift[1].value_or(0);
  if (first + second == 0 && !mechanism.has_word(kShift, kFree)) return;
  mechanism.fault(kShift, "is no pair of opposite numbers; expected [x, -x] of bevel gears");
}

void read_bevel(TableReader& mechanism, GearPairProblem& problem) {
  read_teeth(mechanism, problem);
  problem.module = mechanism.number(kModule, kLinkLength);
  problem.shaft_angle = radians(mechanism.number(kShaft, kShaftAngle).value_or(90));
  problem.face_width = mechanism.number(kFace, kLinkLength).value_or(0);
  read_shifts(mechanism, problem);
  check_bevel_shifts(mechanism, problem);
  for (auto& shift : problem.profile_shift) shift = shift.value_or(0);
  want(mechanism, {kTeethKey, kModule}, "bevel gears are evaluated, not searched for");
  refuse_keys(mechanism,
              {"helix_deg", kDistance, kBacklashKey, kReduction, "starts", "wheel_teeth",
               "diameter_quotient", "wheel_shift", "friction", kPinionTeeth, kPinionShift,
               kRackDistance, kCutterTeeth},
              "bevel gears have none");
}

void read_worm(TableReader& mechanism, GearPairProblem& problem) {
  gear::WormPair& worm = problem.worm;
  worm.starts = mechanism.number("starts", kStarts).value_or(1);
  worm.wheel_teeth = mechanism.number("wheel_teeth", kTeeth).value_or(0);
  problem.module = mechanism.number(kModule, kLinkLength);
  worm.diameter_quotient =
      mechanism.number("diameter_quotient", kDiameterQuotient).value_or(worm.diameter_quotient);
  worm.wheel_shift = mechanism.number("wheel_shift", kProfileShift).value_or(0);
  problem.friction = mechanism.number("friction", kFriction);
  worm.module = problem.module.value_or(1);
  want(mechanism, {"wheel_teeth", kModule}, "worms are evaluated, not searched for");
  refuse_keys(mechanism, {kTeethKey}, "a worm has starts and its wheel wheel_teeth instead");
  refuse_keys(mechanism, {kShift}, "the wheel alone is shifted, by wheel_shift");
  refuse_keys(mechanism, {kDistance},
              "it follows from module, diameter_quotient, wheel_teeth and wheel_shift");
  refuse_keys(mechanism,
              {kBacklashKey, kReduction, kFace, "helix_deg", kShaft, kPinionTeeth, kPinionShift,
               kRackDistance, kCutterTeeth},
              "a worm and its wheel have none");
}

// What only a search has a use for.
void refuse_search(TableReader& document, Gearing gearing) {
  for (const std::string_view table : {"bounds", "target", "solve"}) {
    if (document.has(table)) {
      document.fault(table, fmt::format("is given, but {} gears are evaluated, not searched for; "
                                        "remove it",
                                        to_string(gearing)));
    }
  }
}

void read_constraints(TableReader& table, Gearing gearing, GearConstraints& constraints) {
  if (gearing == Gearing::worm) {
    for (const auto& key : kMeshKeys) {
      refuse_keys(table, {key.in_table()}, "of a worm and its wheel it is not known");
    }
  } else {
    read_keys(table, kMeshKeys, constraints);
  }
  read_keys(table, kToothKeys, constraints);
  table.finish();
}

void check_objective(TableReader& target, const GearPairProblem& problem) {
  if (problem.objective != GearObjective::size || !problem.centre_distance) return;
  target.fault("objective",
               "is \"size\", which centre_distance fixes; expected another objective, or no "
               "centre_distance");
}

void read_search(TableReader& document, TableReader& mechanism, GearPairProblem& problem) {
  TableReader bounds = document.table("bounds");
  TableReader target = document.table("target");
  TableReader solve = document.table("solve");
  read_gear_pair_bounds(mechanism, bounds, problem);
  problem.ratio = target.number("ratio", kGearRatio);
  problem.ratio_tolerance = target.number("ratio_tolerance", kRelativeTolerance).value_or(0);
  if (target.has("ratio_tolerance") && !target.has("ratio")) {
    target.fault("ratio_tolerance", "is given without what it belongs to; expected ratio");
  }
  problem.objective = target.choice<GearObjective>("objective").value_or(problem.objective);
  check_objective(target, problem);
  problem.solve.designs = solve.integer("designs", 1, kMostDesigns).value_or(problem.solve.designs);
  for (TableReader* table : {&bounds, &target, &solve}) table->finish();
}

}  // namespace

}  // namespace cognate::problems::reading

namespace cognate::problems {

GearPairProblem KindTraits<GearPairProblem>::read(reading::TableReader& document,
                                                  const std::filesystem::path& /*folder*/) {
  using namespace reading;
  GearPairProblem problem;
  TableReader mechanism = document.table("mechanism");
  TableReader constraints = document.table("constraints");
  const std::size_t before = document.faults().size();
  problem.gearing = mechanism.choice<Gearing>("gearing").value_or(Gearing::spur);
  const bool known = document.faults().size() == before;
  problem.rack = read_rack(document);
  if (!known) {  // which keys there may be depends on it
    document.know({"bounds", "target", "solve"});
    return problem;
  }
  switch (problem.gearing) {
    case Gearing::spur:
    case Gearing::helical:
      read_cylindrical(mechanism, problem);
      read_search(document, mechanism, problem);
      break;
    case Gearing::internal:
      read_internal(mechanism, problem);
      refuse_search(document, problem.gearing);
      break;
    case Gearing::rack:
      read_rack_pair(mechanism, problem);
      refuse_search(document, problem.gearing);
      break;
    case Gearing::bevel:
      read_bevel(mechanism, problem);
      refuse_search(document, problem.gearing);
      break;
    case Gearing::worm:
      read_worm(mechanism, problem);
      refuse_search(document, problem.gearing);
      break;
  }
  read_constraints(constraints, problem.gearing, problem.constraints);
  mechanism.finish();
  problem.worm.rack = problem.rack;
  return problem;
}

}  // namespace cognate::problems
