/// A pinion in a ring, of which all is given.
#include <fmt/core.h>

#include <cmath>

#include "analysis/numbers/constants.hpp"
#include "problems/gear/notes.hpp"
#include "problems/gear/pair_design.hpp"
#include "problems/gear/pair_quantities.hpp"
#include "problems/gear/quantities.hpp"

namespace cognate::problems {
namespace {

using gear::InternalPair;
using gear::RingFault;

/// Whether both can be made and have a line of action.
bool can_mesh(const InternalPair& pair) {
  const double least = gear::base_radius(pair.ring.twin) - gear::base_radius(pair.pinion);
  return gear::tooth_fault(pair.pinion) == gear::ToothFault::none &&
         gear::ring_fault(pair.ring) == RingFault::none && pair.centre_distance > least;
}

std::string in_words(RingFault fault) {
  switch (fault) {
    case RingFault::none:
      break;
    case RingFault::no_cutting:
      return "no-cutting";
    case RingFault::pointed_tool:
      return "pointed-tool";
    case RingFault::no_flank:
      return "no-flank";
    case RingFault::inside_base:
      return "inside-base-circle";
    case RingFault::pointed:
      return "pointed";
  }
  return "none";
}

class InternalDesign {
 public:
  explicit InternalDesign(const GearPairProblem& asked) : pair_(internal_pair(asked)) {
    design_.settled = asked;
    design_.settled.centre_distance = pair_.centre_distance;
    design_.settled.backlash.reset();
    design_.pair = {{pair_.pinion, pair_.ring.twin}, pair_.centre_distance};
    design_.origin = "given";
  }

  GearPairDesign made() && {
    add_pair();
    const bool meshes = can_mesh(pair_);
    gear::InternalGeometry all;
    if (meshes) {
      all = gear::geometry(pair_);
      add_mesh_quantities(all.mesh, design_);
      add_truth("tips_overlap", all.tip_room < 0);
      add_truth("radial_assembly", all.radial_room >= 0);
    }
    add("pinion.teeth", pair_.pinion.teeth);
    append(design_.metrics, gear_quantities({.normal = pair_.pinion}, "pinion."));
    add_ring();
    if (meshes) {
      add_member(all.mesh.gears[0], "pinion.");
      add_member(all.mesh.gears[1], "wheel.");
    }
    add_checks(meshes, all);
    return std::move(design_);
  }

 private:
  void add(const std::string& name, double value) { design_.metrics.push_back({name, value}); }
  void add_truth(const std::string& name, bool value) { design_.metrics.push_back({name, value}); }

  void add_pair() {
    const auto& pinion = pair_.pinion;
    const auto& twin = pair_.ring.twin;
    add("ratio", twin.teeth / pinion.teeth);
    add("module", pinion.module);
    add("centre_distance", pair_.centre_distance);
    add("reference_centre_distance", gear::reference_radius(twin) - gear::reference_radius(pinion));
    add("zero_backlash_distance", gear::internal_centre_distance(pinion, pair_.ring, 0));
    add("profile_shift_difference", twin.profile_shift - pinion.profile_shift);
  }

  void add_ring() {
    const auto& ring = pair_.ring;
    const double reference = gear::reference_radius(ring.twin), tip = gear::tip_radius(ring);
    const double pitch = kPi * ring.twin.module;
    add("wheel.teeth", ring.twin.teeth);
    add("wheel.profile_shift", ring.twin.profile_shift);
    add("wheel.reference_diameter", 2 * reference);
    add("wheel.base_diameter", 2 * gear::base_radius(ring.twin));
    add("wheel.tip_diameter", 2 * tip);
    add("wheel.addendum", reference - tip);
    add("wheel.pitch", pitch);
    add("wheel.base_pitch", pitch * std::cos(ring.twin.rack.pressure_angle));
    const double thickness = gear::tooth_thickness(ring, reference);
    add("wheel.tooth_thickness", thickness);
    add("wheel.space_width", pitch - thickness);
    if (tip >= gear::base_radius(ring.twin)) {
      add("wheel.tip_thickness", gear::tooth_thickness(ring, tip));
    }
    if (gear::ring_fault(ring) != RingFault::none) return;
    const double root = gear::root_radius(ring);
    add("wheel.root_diameter", 2 * root);
    add("wheel.form_diameter", 2 * gear::form_radius(ring));
    add("wheel.dedendum", root - reference);
    add("wheel.tooth_depth", root - tip);
  }

  void add_member(const gear::GearInMesh& own, const std::string& prefix) {
    add(prefix + "working_diameter", 2 * own.working_radius);
    add(prefix + "contact_start_diameter", 2 * own.contact_start);
    add(prefix + "contact_end_diameter", 2 * own.contact_end);
    add(prefix + "tip_clearance", own.tip_clearance);
    add(prefix + "sliding_start", own.sliding_start);
    add(prefix + "sliding_end", own.sliding_end);
    add_truth(prefix + "interferes", own.interference > 0);
  }

  void at_least(const char* name, double value, double bound, double scale = 1) {
    design_.constraints.push_back(check_of({name, value, bound, true, scale}));
  }

  void add_checks(bool meshes, const gear::InternalGeometry& all) {
    add_pinion_checks(pair_.pinion, design_);
    const auto& ring = pair_.ring;
    const double module = pair_.pinion.module;
    const RingFault fault = gear::ring_fault(ring);
    if (fault == RingFault::none) {
      at_least("tip_thickness_min.wheel",
               gear::tooth_thickness(ring, gear::tip_radius(ring)) / module,
               design_.settled.constraints.tip_thickness_min);
    } else {
      design_.constraints.push_back({"teeth.wheel", in_words(fault), "none", false});
    }
    at_least("centre_distance", pair_.centre_distance,
             gear::base_radius(ring.twin) - gear::base_radius(pair_.pinion), module);
    if (!meshes) return;
    add_mesh_checks(all.mesh, "wheel", design_);
    if (!design_.settled.constraints.no_interference) return;
    const bool overlap = all.tip_room < 0;
    design_.constraints.push_back({"tips_overlap", overlap ? "yes" : "no", "no", !overlap});
  }

  InternalPair pair_;
  GearPairDesign design_;
};

std::string ring_note(const gear::RingGear& ring) {
  switch (gear::ring_fault(ring)) {
    case RingFault::none:
      break;
    case RingFault::no_cutting:
      return fmt::format(
          "A tool of {:g} teeth cannot cut the ring: it does not mesh with it; expected a smaller "
          "cutter_teeth, or a greater shift.",
          ring.cutter_teeth);
    case RingFault::pointed_tool:
      return fmt::format(
          "The teeth of a tool of {:g} end before its tip circle; expected a greater cutter_teeth.",
          ring.cutter_teeth);
    case RingFault::inside_base:
      return fmt::format(
          "The ring's tip circle of radius {:.6g} lies inside its base circle of {:.6g}, where "
          "there is no involute; expected more teeth, a greater shift or tip_reduction.",
          gear::tip_radius(ring), gear::base_radius(ring.twin));
    case RingFault::no_flank:
      return "The ring has no involute flank: its fillet reaches its tip circle.";
    case RingFault::pointed:
      return "The ring's teeth are pointed: their flanks meet before the tip circle.";
  }
  return {};
}

}  // namespace

gear::InternalPair internal_pair(const GearPairProblem& problem) {
  InternalPair pair;
  pair.pinion = helical_gear(problem, 0).normal;
  pair.ring = {helical_gear(problem, 1).normal, double(problem.cutter_teeth)};
  pair.centre_distance = problem.centre_distance.value_or(
      gear::internal_centre_distance(pair.pinion, pair.ring, problem.backlash.value_or(0)));
  return pair;
}

GearPairDesign internal_design(const GearPairProblem& asked) {
  return InternalDesign(asked).made();
}

std::vector<std::string> internal_notes(const GearPairDesign& design) {
  const InternalPair pair = internal_pair(design.settled);
  const GearConstraints& demanded = design.settled.constraints;
  auto notes = gear_notes({.normal = pair.pinion}, "The pinion", !demanded.no_undercut);
  const std::string ring = ring_note(pair.ring);
  if (!ring.empty()) notes.push_back(ring);
  const double least = gear::base_radius(pair.ring.twin) - gear::base_radius(pair.pinion);
  if (!(pair.centre_distance > least)) {
    notes.push_back(fmt::format(
        "There is no line of action: the centre distance must be more than {:.6g}, the difference "
        "of the base radii; expected other shifts or another distance.",
        least));
  }
  if (!can_mesh(pair)) return notes;
  const auto all = gear::geometry(pair);
  append(notes, mesh_notes(all.mesh, "wheel", design));
  if (all.tip_room < 0) {
    notes.push_back(
        allowed("The tips of pinion and ring overlap beside the path of contact; expected "
                "a greater difference of teeth, or a greater tip_reduction.",
                !demanded.no_interference, "no_interference"));
  }
  if (all.tip_room >= 0 && all.radial_room < 0) {
    notes.emplace_back(
        "The pinion goes into the ring along its axis alone: moved in radially its "
        "tips meet the ring's.");
  }
  return notes;
}

}  // namespace cognate::problems
