#include "problems/gear/notes.hpp"

#include <fmt/core.h>

#include <cmath>

#include "problems/gear/pair_design.hpp"

namespace cognate::problems {
namespace {

using gear::SpurGear;
using gear::ToothFault;
using Notes = std::vector<std::string>;

constexpr const char* kNames[] = {"pinion", "wheel"};
constexpr const char* kSubjects[] = {"The pinion", "The wheel"};

/// Shares of a module, and of a radius, below this are rounding.
constexpr double kRounding = 1e-9;

/// Why it cannot be made at all.
std::string fault_note(ToothFault fault, const SpurGear& section, const std::string& name) {
  switch (fault) {
    case ToothFault::rack_overlaps:
      return fmt::format("{} has no rack that cuts it: the rounded corners of its tip overlap.",
                         name);
    case ToothFault::no_root:
      return fmt::format("{} has no root circle: its {:g} teeth are cut to beyond its centre.",
                         name, section.teeth);
    case ToothFault::cut_through:
      return fmt::format("{} has no teeth: the fillets of {:g} teeth cut them off.", name,
                         section.teeth);
    case ToothFault::no_flank:
      return fmt::format(
          "{} has no involute flank: its form circle of radius {:.6g} lies above its tip, of "
          "radius {:.6g}.",
          name, gear::form_radius(section), gear::flank_end_radius(section));
    case ToothFault::none:
      break;
  }
  return {};
}

/// At which centre distances the pair would drive continuously.
std::string where_continuous(const GearPairDesign& design) {
  const auto distances = continuous_distances(design);
  if (!distances) return "it is so at every centre distance at which the teeth do not overlap";
  if (design.pair.centre_distance >= distances->least) {
    return fmt::format("the largest centre distance with contact ratio 1 is {:.6f}",
                       distances->greatest);
  }
  return fmt::format("it is 1 or more at centre distances from {:.6f} to {:.6f}", distances->least,
                     distances->greatest);
}

void add_continuity(const GearPairDesign& design, const gear::PairGeometry& mesh, Notes& notes) {
  const double ratio = total_contact_ratio(design.settled, *design.settled.module, mesh);
  if (!(ratio < 1 - kRounding)) return;
  notes.push_back(
      fmt::format("The pair cannot drive continuously: its contact ratio is {:.6g}, below 1; {}.",
                  ratio, where_continuous(design)));
}

void add_backlash(const gear::SpurPair& pair, const gear::PairGeometry& mesh, Notes& notes) {
  if (!(mesh.backlash < -kRounding * pair.gears[0].module)) return;
  notes.push_back(
      fmt::format("The teeth overlap by {:.6g} on the pitch circles: they mesh from a "
                  "centre distance of {:.6f} on.",
                  -mesh.backlash, gear::centre_distance_without_backlash(pair.gears)));
}

/// What the table of numbers cannot hold.
void add_sliding(const gear::PairGeometry& mesh, Notes& notes) {
  for (std::size_t i = 0; i < 2; ++i) {
    if (std::isfinite(mesh.gears[i].sliding_start)) continue;
    notes.push_back(fmt::format(
        "The specific sliding of the {} is infinite: the path of contact reaches its base circle.",
        kNames[i]));
  }
}

}  // namespace

Notes interference_notes(const gear::SpurPair& pair, const gear::PairGeometry& mesh,
                         bool is_allowed) {
  Notes notes;
  for (std::size_t i = 0; i < 2; ++i) {
    if (mesh.gears[i].interference > 0) {
      const std::string note = fmt::format(
          "The {}'s tips interfere with the {}: they dig into its fillet or root; its "
          "involute begins at radius {:.6g}.",
          kNames[1 - i], kNames[i], gear::form_radius(pair.gears[i]));
      notes.push_back(allowed(note, is_allowed, "no_interference"));
    }
    if (mesh.gears[i].tip_clearance < -kRounding * pair.gears[0].module) {
      notes.push_back(fmt::format("The {}'s tips reach {:.6g} below the root circle of the {}.",
                                  kNames[i], -mesh.gears[i].tip_clearance, kNames[1 - i]));
    }
  }
  return notes;
}

std::string undercut_note(const SpurGear& section, double needed_shift, const std::string& name) {
  if (!gear::is_undercut(section)) return {};
  return fmt::format(
      "{} is undercut: {:.6g} teeth need a profile shift of at least {:.4f}, or this shift at "
      "least {:g} teeth.",
      name, section.teeth, needed_shift,
      std::ceil(gear::least_teeth(section.rack, section.profile_shift) - kRounding));
}

std::string undercut_note_of_cone(const SpurGear& section, double cosine, const std::string& name) {
  if (!gear::is_undercut(section)) return {};
  const double least = gear::least_teeth(section.rack, section.profile_shift) * cosine;
  return fmt::format(
      "{} is undercut: {:.6g} teeth on its cone (a virtual gear of {:.6g}) need a profile shift of "
      "at least {:.4f}, or this shift at least {:g} teeth on the same cone.",
      name, section.teeth * cosine, section.teeth,
      gear::least_profile_shift(section.rack, section.teeth), std::ceil(least - kRounding));
}

std::string allowed(const std::string& note, bool is_allowed, const char* key) {
  if (note.empty() || !is_allowed) return note;
  return fmt::format("Allowed by {} = false: {}", key, note);
}

Notes section_notes(const SpurGear& section, const std::string& undercut, const std::string& name) {
  const ToothFault fault = gear::tooth_fault(section);
  if (fault != ToothFault::none) return {fault_note(fault, section, name)};
  Notes notes;
  if (!undercut.empty()) notes.push_back(undercut);
  const double tip = gear::tip_radius(section), pointed = gear::pointed_radius(section);
  if (tip > pointed * (1 + kRounding)) {
    notes.push_back(
        fmt::format("{} is pointed: its flanks meet at radius {:.6g}, below the tip "
                    "circle of radius {:.6g}.",
                    name, pointed, tip));
  }
  return notes;
}

Notes gear_notes(const gear::HelicalGear& gear, const std::string& name, bool undercut_is_allowed) {
  const SpurGear section = gear::transverse(gear);
  const double needed =
      gear::least_profile_shift(section.rack, section.teeth) / std::cos(gear.helix);
  const std::string undercut = undercut_note(section, needed, name);
  return section_notes(section, allowed(undercut, undercut_is_allowed, "no_undercut"), name);
}

Notes gear_pair_notes(const GearPairDesign& design) {
  Notes notes;
  const GearConstraints& demanded = design.settled.constraints;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto own =
        gear_notes(helical_gear(design.settled, i), kSubjects[i], !demanded.no_undercut);
    notes.insert(notes.end(), own.begin(), own.end());
  }
  const double least = gear::sum_of_base_radii(design.pair.gears);
  if (!(design.pair.centre_distance > least)) {
    notes.push_back(
        fmt::format("The base circles overlap: the centre distance is {:.6g}, less than "
                    "the sum of their radii, {:.6g}; such gears cannot mesh.",
                    design.pair.centre_distance, least));
  }
  const auto mesh = mesh_of(design.pair);
  if (!mesh) return notes;
  add_continuity(design, *mesh, notes);
  add_backlash(design.pair, *mesh, notes);
  const auto digs = interference_notes(design.pair, *mesh, !demanded.no_interference);
  notes.insert(notes.end(), digs.begin(), digs.end());
  add_sliding(*mesh, notes);
  return notes;
}

}  // namespace cognate::problems
