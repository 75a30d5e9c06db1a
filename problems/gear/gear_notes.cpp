#include "problems/gear/gear_notes.hpp"

#include <fmt/core.h>

#include <cmath>

#include "problems/gear/gear_pair_design.hpp"
#include "problems/gear/gear_pair_limits.hpp"

namespace cognate::problems {
namespace {

using gear::SpurGear;
using Notes = std::vector<std::string>;

/// Lengths below this share of a module are rounding.
constexpr double kRounding = 1e-9;

void add_continuity(const GearPairDesign& design, Notes& notes) {
  const double ratio = total_contact_ratio(design.settled, gear::geometry(design.pair));
  if (!(ratio < 1 - kRounding)) return;
  const auto most = greatest_continuous_distance(design);
  const std::string remedy =
      most ? fmt::format("the largest centre distance with contact ratio 1 is {:.6f}", *most)
           : "it is below 1 even without backlash";
  notes.push_back(fmt::format(
      "The pair cannot drive continuously: its contact ratio is {:.6g}; {}.", ratio, remedy));
}

void add_backlash(const GearPairDesign& design, const gear::PairGeometry& mesh, Notes& notes) {
  if (!(mesh.backlash < -kRounding * design.pair.gears[0].module)) return;
  const double free = gear::centre_distance_without_backlash(design.pair.gears);
  notes.push_back(fmt::format("The teeth overlap by {:.6g} on the pitch circles; they mesh from a "
                              "centre distance of {:.6f} on.",
                              -mesh.backlash, free));
}

void add_interference(const GearPairDesign& design, const gear::PairGeometry& mesh, Notes& notes) {
  for (std::size_t i = 0; i < 2; ++i) {
    const auto& own = mesh.gears[i];
    const char* name = i == 0 ? "pinion" : "wheel";
    const char* other = i == 0 ? "wheel" : "pinion";
    if (own.interferes) {
      notes.push_back(fmt::format(
          "The {}'s tips reach below the involute of the {}, which begins at radius {:.6g}: they "
          "interfere.",
          other, name, gear::form_radius(design.pair.gears[i])));
    }
    if (own.tip_clearance < -kRounding * design.pair.gears[0].module) {
      notes.push_back(fmt::format("The {}'s tips would cut {:.6g} into the root circle of the {}.",
                                  name, -own.tip_clearance, other));
    }
  }
}

}  // namespace

Notes gear_notes(const gear::HelicalGear& gear, const std::string& name) {
  Notes notes;
  const SpurGear section = gear::transverse(gear);
  if (gear::is_undercut(section)) {
    notes.push_back(fmt::format(
        "{} is undercut: {:g} teeth need a profile shift of at least {:.4f}, or a shift of {:g} at "
        "least {:.4g} teeth.",
        name, section.teeth,
        gear::least_profile_shift(section.rack, section.teeth) / std::cos(gear.helix),
        gear.normal.profile_shift,
        std::ceil(gear::least_teeth(section.rack, section.profile_shift) - kRounding)));
  }
  const double tip = gear::tip_radius(section), pointed = gear::pointed_radius(section);
  if (tip > pointed * (1 + kRounding)) {
    notes.push_back(fmt::format("{} is pointed: its flanks meet at radius {:.6g}, below the tip "
                                "circle of radius {:.6g}.",
                                name, pointed, tip));
  }
  if (tip <= gear::form_radius(section)) {
    notes.push_back(fmt::format("{} has no involute flank: its tip circle of radius {:.6g} lies "
                                "below the form circle of radius {:.6g}.",
                                name, tip, gear::form_radius(section)));
  }
  return notes;
}

Notes gear_pair_notes(const GearPairDesign& design) {
  Notes notes;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto own =
        gear_notes(helical_gear(design.settled, i), i == 0 ? "The pinion" : "The wheel");
    notes.insert(notes.end(), own.begin(), own.end());
  }
  const double least = gear::base_radius(design.pair.gears[0]) +
                       gear::base_radius(design.pair.gears[1]);
  if (!(design.pair.centre_distance >= least)) {
    notes.push_back(fmt::format("The base circles overlap: the centre distance is {:.6g}, less than "
                                "the sum of their radii, {:.6g}; such gears cannot mesh.",
                                design.pair.centre_distance, least));
    return notes;
  }
  const auto mesh = gear::geometry(design.pair);
  add_continuity(design, notes);
  add_backlash(design, mesh, notes);
  add_interference(design, mesh, notes);
  return notes;
}

}  // namespace cognate::problems
