#include "problems/gear/read.hpp"

#include <fmt/core.h>

#include <cmath>

#include "analysis/numbers/constants.hpp"
#include "problems/gear/keys.hpp"
#include "problems/gear/quantities.hpp"

namespace cognate::problems::reading {
namespace {

constexpr std::string_view kHelixKey = "helix_deg", kSpanTeeth = "span_teeth";
constexpr int kMostPoints = 10000;

// Bevel gears and worms are described by their pair.
Gearing read_gearing(TableReader& mechanism) {
  const auto gearing = mechanism.choice<Gearing>("gearing").value_or(Gearing::spur);
  if (gearing == Gearing::spur || gearing == Gearing::helical) return gearing;
  mechanism.fault(
      "gearing",
      fmt::format("is \"{}\", and such gears are made in pairs alone; expected \"spur\", "
                  "\"helical\", or kind = \"gear-pair\"",
                  to_string(gearing)));
  return Gearing::spur;
}

// That something is left of the gear below its teeth.
void check_root(TableReader& mechanism, const GearProblem& problem) {
  const gear::SpurGear section = gear::transverse(problem.gear);
  if (gear::root_radius(section) > 0) return;
  mechanism.fault(
      kTeethKey,
      fmt::format("is {:g}, so few that the rack cuts to beyond the gear's centre; expected more "
                  "teeth, or a greater profile_shift",
                  problem.gear.normal.teeth));
}

void check_tip(TableReader& mechanism, const GearProblem& problem) {
  const gear::SpurGear section = gear::transverse(problem.gear);
  if (gear::tip_radius(section) > gear::root_radius(section)) return;
  mechanism.fault(kReduction, fmt::format("is {:g}, which leaves no tooth above the root circle; "
                                          "expected less",
                                          problem.gear.normal.tip_reduction));
}

// That the span over the teeth asked for can be taken.
void check_span(TableReader& output, const GearProblem& problem) {
  if (!problem.span_teeth || span_over(problem.gear, *problem.span_teeth)) return;
  const auto range = span_range(problem.gear);
  const std::string allowed =
      range ? fmt::format("allowed is a number from {} to {}", (*range)[0], (*range)[1])
            : "over no number of teeth do they; remove it";
  output.fault(kSpanTeeth, fmt::format("is {}, over which anvils do not touch the involute on both "
                                       "sides; {}",
                                       *problem.span_teeth, allowed));
}

}  // namespace

gear::BasicRack read_rack(TableReader& document) {
  TableReader table = document.table("rack");
  const std::size_t before = document.faults().size();
  gear::BasicRack rack;
  read_keys(table, kRackKeys, rack);
  table.finish();
  if (document.faults().size() > before) return rack;
  const double greatest = gear::greatest_tip_radius(rack);
  if (greatest < 0) {
    document.fault(
        "rack", fmt::format("has flanks that meet before its tip; expected addendum and clearance "
                            "of at most {:.4g} modules together, or a lesser "
                            "pressure_angle_deg",
                            kPi / 4 / std::tan(rack.pressure_angle)));
  } else if (rack.corner_radius && *rack.corner_radius > greatest) {
    table.fault("tip_radius",
                fmt::format("is {:g}, so that the tip's corners overlap; at most {:.6g}, "
                            "which rounds it fully, is allowed",
                            *rack.corner_radius, greatest));
  }
  return rack;
}

void refuse_keys(TableReader& table, std::initializer_list<std::string_view> keys,
                 std::string_view why) {
  for (const auto key : keys) {
    // A key that is not there stays unknown, so that no list of allowed ones names it.
    if (table.contains(key) && table.has(key))
      table.fault(key, fmt::format("is given, but {}; remove it", why));
  }
}

double read_helix(TableReader& mechanism, Gearing gearing) {
  if (gearing != Gearing::helical) {
    refuse_keys(mechanism, {kHelixKey}, fmt::format("{} gears have none", to_string(gearing)));
    return 0;
  }
  const auto helix = mechanism.number(kHelixKey, kHelix);
  if (!mechanism.has(kHelixKey)) {
    mechanism.fault(kHelixKey, fmt::format("is missing; expected {}", kHelix.allowed));
  }
  return radians(helix.value_or(0));
}

}  // namespace cognate::problems::reading

namespace cognate::problems {

GearProblem KindTraits<GearProblem>::read(reading::TableReader& document,
                                          const std::filesystem::path& /*folder*/) {
  using namespace reading;
  GearProblem problem;
  const std::size_t before = document.faults().size();
  TableReader mechanism = document.table("mechanism");
  TableReader output = document.table("output");
  problem.gearing = read_gearing(mechanism);
  gear::SpurGear& gear = problem.gear.normal;
  const auto teeth = mechanism.number(kTeethKey, kTeeth);
  const auto module = mechanism.number("module", kLinkLength);
  for (const auto& [key, wanted] : {std::pair{kTeethKey, "a whole number"},
                                    std::pair{std::string_view("module"), "a length"}}) {
    if (!mechanism.has(key)) mechanism.fault(key, fmt::format("is missing; expected {}", wanted));
  }
  gear.profile_shift = mechanism.number(kShift, kProfileShift).value_or(0);
  gear.tip_reduction = mechanism.number(kReduction, kTipReduction).value_or(0);
  problem.gear.helix = read_helix(mechanism, problem.gearing);
  problem.gear.face_width = mechanism.number("face_width", kLinkLength).value_or(0);
  gear.rack = read_rack(document);
  problem.points = output.integer("points", 1, kMostPoints).value_or(problem.points);
  problem.span_teeth = output.integer(kSpanTeeth, 1, kMostTeeth);
  mechanism.finish();
  output.finish();
  if (document.faults().size() > before || !teeth || !module) return problem;
  gear.teeth = *teeth;
  gear.module = *module;
  check_root(mechanism, problem);
  check_tip(mechanism, problem);
  if (document.faults().size() == before) check_span(output, problem);
  return problem;
}

}  // namespace cognate::problems
