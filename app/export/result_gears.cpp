#include <fmt/core.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>

#include "analysis/gear/mesh.hpp"
#include "app/export/exported.hpp"
#include "app/export/toml_text.hpp"
#include "problems/basics/names.hpp"
#include "problems/gear/pair_design.hpp"
#include "problems/gear/pair_limits.hpp"
#include "problems/gear/result.hpp"
#include "problems/read.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;
using problems::GearPairProblem;
using Made = tl::expected<ResultGears, std::string>;

/// The problem file that gives the mechanism of `given` and leaves nothing free.
std::string problem_text(const ResultDesign& given, const char* kind) {
  ordered_json tables = head_of(given, kind);
  for (const auto& [key, value] : given.table["mechanism"].items()) {
    if (key == "type") continue;
    if (key == "rack") {
      tables["rack"] = value;
    } else {
      tables["mechanism"][key] = value;
    }
  }
  return toml_text(tables);
}

/// Why `gear` has no outline; null where it has one.
const char* fault_of(const gear::SpurGear& gear) {
  switch (gear::tooth_fault(gear)) {
    case gear::ToothFault::none:
      return nullptr;
    case gear::ToothFault::rack_overlaps:
      return "the rounded corners of its rack's tip overlap";
    case gear::ToothFault::no_root:
      return "the rack cuts to beyond its centre";
    case gear::ToothFault::cut_through:
      return "the rack cuts its teeth off";
    case gear::ToothFault::no_flank:
      return "nothing is left of its involute";
  }
  return nullptr;
}

void note_undercut(ResultGears& gears) {
  for (const GearPose& gear : gears.gears) {
    if (gear.ring || gear.rack || !gear::is_undercut(gear.section)) continue;
    gears.notes.push_back(
        fmt::format("the {} is undercut", gear.name.empty() ? "gear" : gear.name));
  }
}

Made gear_of(const ResultDesign& given) {
  const auto problem = problems::parse_task<problems::GearProblem>(problem_text(given, "gear"));
  if (!problem) return tl::unexpected(problem.error().front().message);
  const gear::SpurGear section = gear::transverse(problem->gear);
  if (const char* fault = fault_of(section)) {
    return tl::unexpected(
        fmt::format("the gear has no outline, since {}; expected a gear that can be made", fault));
  }
  ResultGears made{problem->title,
                   std::string(problems::to_string(problem->gearing)),
                   problem->length_unit,
                   {},
                   {}};
  made.gears = {{.section = section,
                 .pitch_radius = gear::reference_radius(section),
                 .helix = problem->gear.helix}};
  if (problem->gear.face_width > 0) made.face_width = problem->gear.face_width;
  return made;
}

/// What the table of a pair must have beyond what can be read.
std::string missing(const GearPairProblem& problem) {
  const bool whole = problem.teeth[0] && problem.teeth[1] && problem.module &&
                     problem.profile_shift[0] && problem.profile_shift[1] &&
                     problem.centre_distance;
  if (whole) return {};
  return "it is not whole; expected teeth, module, both values of profile_shift and "
         "centre_distance";
}

void note_contact(const gear::PairGeometry& contact, ResultGears& gears) {
  if (contact.backlash < 0) {
    gears.notes.push_back(
        fmt::format("the teeth overlap by {:.6g} on the pitch circles", -contact.backlash));
  }
  if (contact.contact_ratio < 1 && gears.gearing != "helical") {
    gears.notes.push_back(fmt::format("the contact ratio is {:.4g}: contact is lost between teeth",
                                      contact.contact_ratio));
  }
}

ResultGears head_of_gears(const GearPairProblem& problem) {
  return {problem.title,
          std::string(problems::to_string(problem.gearing)),
          problem.length_unit,
          {},
          {},
          problem.face_width > 0 ? std::optional(problem.face_width) : std::nullopt};
}

Made in_mesh(const GearPairProblem& problem, const gear::SpurPair& pair) {
  const auto mesh = gear::mesh(pair);
  const auto contact = gear::geometry_of_line(pair);
  if (!std::isfinite(mesh.wheel_angle)) {
    return tl::unexpected(std::string(
        "its base circles overlap, so the gears do not mesh; expected a greater centre_distance"));
  }
  ResultGears made = head_of_gears(problem);
  made.gears = {{.name = "pinion",
                 .section = pair.gears[0],
                 .pitch_radius = contact.gears[0].working_radius,
                 .helix = problem.helix},
                {.name = "wheel",
                 .section = pair.gears[1],
                 .centre = mesh.wheel_centre,
                 .angle = mesh.wheel_angle,
                 .pitch_radius = contact.gears[1].working_radius,
                 .helix = -problem.helix}};
  note_contact(contact, made);
  return made;
}

Made without_outline(const char* which, const char* fault) {
  return tl::unexpected(fmt::format(
      "the {} has no outline, since {}; expected gears that can be made", which, fault));
}

/// The pinion and the ring about (0, −a′).
Made internal_of(const GearPairProblem& problem) {
  const gear::InternalPair pair = problems::internal_pair(problem);
  if (const char* fault = fault_of(pair.pinion)) return without_outline("pinion", fault);
  if (gear::ring_fault(pair.ring) != gear::RingFault::none) {
    return without_outline("ring", "its tool leaves no involute");
  }
  const double angle = gear::ring_angle(pair);
  if (!std::isfinite(angle)) {
    return tl::unexpected(
        std::string("there is no line of action; expected another centre_distance"));
  }
  ResultGears made = head_of_gears(problem);
  const auto all = gear::geometry(pair);
  made.gears = {{"pinion", pair.pinion, {}, 0, all.mesh.gears[0].working_radius},
                {"wheel",
                 pair.ring.twin,
                 {0, -pair.centre_distance},
                 angle,
                 all.mesh.gears[1].working_radius,
                 pair.ring}};
  note_contact(all.mesh, made);
  if (all.tip_room < 0) made.notes.emplace_back("the tips of pinion and ring overlap");
  return made;
}

/// The pinion and the rack above it.
Made rack_of(const GearPairProblem& problem) {
  const gear::RackPair pair = problems::rack_pair(problem);
  if (const char* fault = fault_of(pair.pinion)) return without_outline("pinion", fault);
  ResultGears made = head_of_gears(problem);
  const auto mesh = gear::geometry(pair);
  const double reference = gear::reference_radius(pair.pinion);
  made.gears = {{"pinion", pair.pinion, {}, 0, reference},
                {.name = "rack",
                 .section = pair.pinion,
                 .pitch_radius = reference,
                 .rack = pair,
                 .offset = 0.5 * mesh.backlash}};
  note_contact(mesh, made);
  return made;
}

Made pair_of(const ResultDesign& given) {
  const auto problem =
      problems::parse_task<problems::GearPairProblem>(problem_text(given, "gear-pair"));
  if (!problem) return tl::unexpected(problem.error().front().message);
  if (problem->gearing == problems::Gearing::internal) return internal_of(*problem);
  if (problem->gearing == problems::Gearing::rack) return rack_of(*problem);
  if (const auto what = missing(*problem); !what.empty()) return tl::unexpected(what);
  const problems::GearPairNumbers numbers{{*problem->teeth[0], *problem->teeth[1]},
                                          *problem->module,
                                          {*problem->profile_shift[0], *problem->profile_shift[1]},
                                          *problem->centre_distance};
  const gear::SpurPair pair = section_of(*problem, numbers);
  for (const int i : {0, 1}) {
    if (const char* fault = fault_of(pair.gears[static_cast<std::size_t>(i)])) {
      return without_outline(i == 0 ? "pinion" : "wheel", fault);
    }
  }
  return in_mesh(*problem, pair);
}

/// Teeth of bevel gears and worms are no outline in a plane.
std::string refusal_of(std::string_view gearing) {
  if (gearing == "bevel") {
    return "the teeth of bevel gears lie on cones and have no outline in a plane; expected spur or "
           "helical "
           "gears (kind = \"gear\" with the virtual_teeth of one, rounded, comes near "
           "it)";
  }
  if (gearing == "worm") {
    return "the teeth of a worm and its wheel have no outline in a plane; expected spur or helical "
           "gears (kind = \"gear\" with wheel_teeth and wheel_shift is the wheel's middle plane)";
  }
  return {};
}

}  // namespace

Made result_gears(const ResultDesign& given) {
  const ordered_json& mechanism = given.table["mechanism"];
  std::string what = refusal_of(text_under(mechanism, "gearing"));
  if (what.empty()) {
    auto made = text_under(mechanism, "type") == "gear" ? gear_of(given) : pair_of(given);
    if (made) {
      note_undercut(*made);
      return made;
    }
    what = made.error();
  }
  return tl::unexpected(
      fmt::format("{}: designs[{}].mechanism: {}", given.name, given.design - 1, what));
}

}  // namespace cognate::app
