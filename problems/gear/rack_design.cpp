/// A pinion on a rack, of which all is given.
#include <cmath>

#include "analysis/numbers/constants.hpp"
#include "problems/gear/notes.hpp"
#include "problems/gear/pair_design.hpp"
#include "problems/gear/pair_quantities.hpp"
#include "problems/gear/quantities.hpp"

namespace cognate::problems {
namespace {

class RackDesign {
 public:
  explicit RackDesign(const GearPairProblem& asked) : pair_(rack_pair(asked)) {
    design_.settled = asked;
    design_.settled.centre_distance = pair_.distance;
    design_.settled.backlash.reset();
    design_.pair.gears[0] = pair_.pinion;
    design_.pair.centre_distance = pair_.distance;
    design_.origin = "given";
  }

  GearPairDesign made() && {
    const bool meshes = gear::tooth_fault(pair_.pinion) == gear::ToothFault::none;
    const gear::PairGeometry mesh = gear::geometry(pair_);
    add("module", pair_.pinion.module);
    add("rack_distance", pair_.distance);
    add("travel_per_turn", kPi * pair_.pinion.module * pair_.pinion.teeth);
    if (meshes) add_mesh_quantities(mesh, design_);
    add("pinion.teeth", pair_.pinion.teeth);
    append(design_.metrics, gear_quantities({.normal = pair_.pinion}, "pinion."));
    add_rack();
    if (meshes) {
      add_member(mesh.gears[0], "pinion.");
      add("pinion.working_diameter", 2 * mesh.gears[0].working_radius);
      add("pinion.contact_start_diameter", 2 * mesh.gears[0].contact_start);
      add("pinion.contact_end_diameter", 2 * mesh.gears[0].contact_end);
      add_member(mesh.gears[1], "rack.");
    }
    add_pinion_checks(pair_.pinion, design_);
    design_.constraints.push_back(
        check_of({"tip_thickness_min.rack", tip_thickness() / pair_.pinion.module,
                  design_.settled.constraints.tip_thickness_min, true, 1}));
    if (meshes) add_mesh_checks(mesh, "rack", design_);
    return std::move(design_);
  }

 private:
  void add(const std::string& name, double value) { design_.metrics.push_back({name, value}); }

  void add_rack() {
    const auto& rack = pair_.pinion.rack;
    const double module = pair_.pinion.module, pitch = kPi * module;
    const double addendum = (rack.addendum - pair_.tip_reduction) * module;
    const double dedendum = (rack.addendum + rack.clearance) * module;
    add("rack.addendum", addendum);
    add("rack.dedendum", dedendum);
    add("rack.tooth_depth", addendum + dedendum);
    add("rack.pitch", pitch);
    add("rack.base_pitch", pitch * std::cos(rack.pressure_angle));
    add("rack.tooth_thickness", 0.5 * pitch);
    add("rack.tip_thickness", tip_thickness());
  }

  double tip_thickness() const {
    const auto& rack = pair_.pinion.rack;
    const double addendum = (rack.addendum - pair_.tip_reduction) * pair_.pinion.module;
    return 0.5 * kPi * pair_.pinion.module - 2 * addendum * std::tan(rack.pressure_angle);
  }

  void add_member(const gear::GearInMesh& own, const std::string& prefix) {
    add(prefix + "tip_clearance", own.tip_clearance);
    add(prefix + "sliding_start", own.sliding_start);
    add(prefix + "sliding_end", own.sliding_end);
    design_.metrics.push_back({prefix + "interferes", own.interference > 0});
  }

  gear::RackPair pair_;
  GearPairDesign design_;
};

}  // namespace

gear::RackPair rack_pair(const GearPairProblem& problem) {
  gear::RackPair pair;
  pair.pinion = helical_gear(problem, 0).normal;
  pair.tip_reduction = problem.tip_reduction[1];
  pair.distance = problem.centre_distance.value_or(
      gear::rack_distance(pair.pinion, problem.backlash.value_or(0)));
  return pair;
}

GearPairDesign rack_design(const GearPairProblem& asked) {
  return RackDesign(asked).made();
}

std::vector<std::string> rack_notes(const GearPairDesign& design) {
  const gear::RackPair pair = rack_pair(design.settled);
  auto notes =
      gear_notes({.normal = pair.pinion}, "The pinion", !design.settled.constraints.no_undercut);
  if (gear::tooth_fault(pair.pinion) != gear::ToothFault::none) return notes;
  append(notes, mesh_notes(gear::geometry(pair), "rack", design));
  return notes;
}

}  // namespace cognate::problems
