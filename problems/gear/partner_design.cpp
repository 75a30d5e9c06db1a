/// What a pinion in a ring and a pinion on a rack have in common: quantities, checks and notes of
/// their mesh.
#include <fmt/core.h>

#include <cmath>

#include "problems/basics/degrees.hpp"
#include "problems/gear/notes.hpp"
#include "problems/gear/pair_design.hpp"

namespace cognate::problems {
namespace {

constexpr double kRoundingOfMesh = 1e-9;

void check(GearPairDesign& design, const std::string& name, double value, double bound,
           bool at_least, double scale = 1) {
  ConstraintCheck made = check_of({"", value, bound, at_least, scale});
  made.name = name;
  design.constraints.push_back(std::move(made));
}

}  // namespace

void add_mesh_quantities(const gear::PairGeometry& mesh, GearPairDesign& design) {
  const auto add = [&](const char* name, double value) { design.metrics.push_back({name, value}); };
  add("working_pressure_angle_deg", degrees(mesh.working_pressure_angle));
  add("contact_ratio", mesh.contact_ratio);
  add("path_length", mesh.path_length);
  add("approach_length", mesh.approach);
  add("recess_length", mesh.recess);
  add("backlash", mesh.backlash);
  add("normal_backlash", mesh.normal_backlash);
  add("sliding_max", greatest_sliding(mesh));
  add("sliding_speed_ratio_max", mesh.greatest_sliding_speed);
}

void add_mesh_checks(const gear::PairGeometry& mesh, const char* partner, GearPairDesign& design) {
  const GearConstraints& demanded = design.settled.constraints;
  const double module = *design.settled.module;
  check(design, "contact_ratio_min", mesh.contact_ratio, demanded.contact_ratio_min, true);
  check(design, "backlash", mesh.backlash, 0, true, module);
  if (demanded.sliding_max) {
    check(design, "sliding_max", greatest_sliding(mesh), *demanded.sliding_max, false);
  }
  for (std::size_t i = 0; i < 2; ++i) {
    const std::string name = i == 0 ? "pinion" : partner;
    const auto& own = mesh.gears[i];
    if (demanded.no_interference) {
      check(design, "no_interference." + name, own.interference / module, 0, false);
    }
    check(design, "tip_clearance_min." + name, own.tip_clearance / module,
          demanded.tip_clearance_min.value_or(0), true);
  }
}

void add_pinion_checks(const gear::SpurGear& pinion, GearPairDesign& design) {
  const auto fault = gear::tooth_fault(pinion);
  if (fault != gear::ToothFault::none) {
    design.constraints.push_back(check_of({"teeth.pinion", double(fault), 0, false, 1}));
  }
  const GearConstraints& demanded = design.settled.constraints;
  const double tip = gear::tip_radius(pinion);
  if (tip >= gear::base_radius(pinion)) {
    check(design, "tip_thickness_min.pinion", gear::tooth_thickness(pinion, tip) / pinion.module,
          demanded.tip_thickness_min, true);
  }
  if (!demanded.no_undercut) return;
  check(design, "no_undercut.pinion", pinion.profile_shift,
        gear::least_profile_shift(pinion.rack, pinion.teeth), true);
}

std::vector<std::string> mesh_notes(const gear::PairGeometry& mesh, const char* partner,
                                    const GearPairDesign& design) {
  std::vector<std::string> notes;
  const double module = *design.settled.module;
  const bool is_allowed = !design.settled.constraints.no_interference;
  if (mesh.contact_ratio < 1 - kRoundingOfMesh) {
    notes.push_back(
        fmt::format("The pair cannot drive continuously: its contact ratio is {:.6g}, below 1.",
                    mesh.contact_ratio));
  }
  if (mesh.backlash < -kRoundingOfMesh * module) {
    notes.push_back(
        fmt::format("The teeth overlap by {:.6g} on the pitch circles.", -mesh.backlash));
  }
  const char* const names[] = {"pinion", partner};
  for (std::size_t i = 0; i < 2; ++i) {
    const auto& own = mesh.gears[i];
    if (!std::isfinite(own.sliding_start)) {
      notes.push_back(
          fmt::format("The specific sliding of the {} is infinite: the path of contact reaches its "
                      "base circle.",
                      names[i]));
    }
    if (own.interference > 0) {
      const std::string note = fmt::format(
          "The {}'s tips pass the end of the {}'s flank by {:.6g} along the line of action: they "
          "interfere.",
          names[1 - i], names[i], own.interference);
      notes.push_back(allowed(note, is_allowed, "no_interference"));
    }
    if (own.tip_clearance < -kRoundingOfMesh * module) {
      notes.push_back(fmt::format("The {}'s tips reach {:.6g} below the root of the {}.", names[i],
                                  -own.tip_clearance, names[1 - i]));
    }
  }
  return notes;
}

}  // namespace cognate::problems
