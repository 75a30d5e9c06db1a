/// Straight bevel gears of which all is given.
#include <fmt/core.h>

#include <cmath>

#include "analysis/numbers/constants.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/gear/notes.hpp"
#include "problems/gear/pair_design.hpp"
#include "problems/gear/pair_quantities.hpp"

namespace cognate::problems {
namespace {

/// Whether both are external gears, to which virtual gears apply.
bool is_external(const gear::BevelPair& pair) {
  return gear::bevel_gear(pair, 0).cone_angle < kRightAngle &&
         gear::bevel_gear(pair, 1).cone_angle < kRightAngle;
}

class BevelDesign {
 public:
  explicit BevelDesign(const GearPairProblem& asked)
      : pair_(bevel_pair(asked)), gears_{gear::bevel_gear(pair_, 0), gear::bevel_gear(pair_, 1)} {
    design_.settled = asked;
    design_.pair = gear::virtual_pair(pair_);
    design_.origin = "given";
  }

  GearPairDesign made() && {
    add_quantities();
    add_checks();
    return std::move(design_);
  }

 private:
  void add(const std::string& name, double value) { design_.metrics.push_back({name, value}); }
  void below(const char* name, double value, double bound) {
    design_.constraints.push_back({name, value, bound, value < bound});
  }

  void add_quantities() {
    add("ratio", pair_.teeth[1] / pair_.teeth[0]);
    add("module", pair_.module);
    add("shaft_angle_deg", degrees(pair_.shaft_angle));
    add("cone_distance", gears_[0].cone_distance);
    mesh_ = is_external(pair_) ? mesh_of(design_.pair) : std::nullopt;
    if (mesh_) {
      add("working_pressure_angle_deg", degrees(mesh_->working_pressure_angle));
      add("contact_ratio", mesh_->contact_ratio);
      add("sliding_max", greatest_sliding(*mesh_));
    }
    for (std::size_t i = 0; i < 2; ++i) add_gear(i, i == 0 ? "pinion." : "wheel.");
  }

  void add_gear(std::size_t i, const std::string& prefix) {
    const gear::BevelGear& own = gears_[i];
    add(prefix + "teeth", pair_.teeth[i]);
    add(prefix + "profile_shift", pair_.profile_shift[i]);
    add(prefix + "reference_diameter", pair_.module * pair_.teeth[i]);
    add(prefix + "tip_diameter", own.outer_tip_diameter);
    add(prefix + "root_diameter", own.outer_root_diameter);
    add(prefix + "cone_angle_deg", degrees(own.cone_angle));
    add(prefix + "tip_angle_deg", degrees(own.tip_angle));
    add(prefix + "root_angle_deg", degrees(own.root_angle));
    add(prefix + "mean_module", own.mean_module);
    if (!is_external(pair_)) return;
    add(prefix + "virtual_teeth", own.virtual_gear.teeth);
    const bool undercut = gear::is_undercut(own.virtual_gear);
    design_.metrics.push_back({prefix + "undercut", undercut});
    add(prefix + "least_profile_shift",
        gear::least_profile_shift(own.virtual_gear.rack, own.virtual_gear.teeth));
    if (!mesh_) return;
    add(prefix + "tip_thickness",
        gear::tooth_thickness(own.virtual_gear, gear::tip_radius(own.virtual_gear)));
    add(prefix + "sliding_start", mesh_->gears[i].sliding_start);
    add(prefix + "sliding_end", mesh_->gears[i].sliding_end);
    design_.metrics.push_back({prefix + "interferes", mesh_->gears[i].interference > 0});
  }

  void add_checks() {
    if (pair_.face_width > 0) below("face_width", pair_.face_width, gears_[0].cone_distance);
    below("cone_angle_deg.pinion", degrees(gears_[0].cone_angle), 90);
    below("cone_angle_deg.wheel", degrees(gears_[1].cone_angle), 90);
    if (!is_external(pair_)) return;
    const GearPairNumbers numbers{{*design_.settled.teeth[0], *design_.settled.teeth[1]},
                                  pair_.module,
                                  pair_.profile_shift,
                                  design_.pair.centre_distance};
    GearPairProblem whole = design_.settled;
    whole.centre_distance = numbers.centre_distance;
    whole.profile_shift = {pair_.profile_shift[0], pair_.profile_shift[1]};
    const GearLimits limits(whole, numbers, design_.pair, mesh_);
    for (const auto& limit : limits.all()) design_.constraints.push_back(check_of(limit));
  }

  gear::BevelPair pair_;
  std::array<gear::BevelGear, 2> gears_;
  std::optional<gear::PairGeometry> mesh_;
  GearPairDesign design_;
};

}  // namespace

gear::BevelPair bevel_pair(const GearPairProblem& problem) {
  gear::BevelPair pair;
  for (std::size_t i = 0; i < 2; ++i) {
    pair.teeth[i] = problem.teeth[i].value_or(0);
    pair.profile_shift[i] = problem.profile_shift[i].value_or(0);
  }
  pair.module = problem.module.value_or(1);
  pair.shaft_angle = problem.shaft_angle;
  pair.face_width = problem.face_width;
  pair.rack = problem.rack;
  return pair;
}

GearPairDesign bevel_design(const GearPairProblem& asked) {
  return BevelDesign(asked).made();
}

std::vector<std::string> bevel_notes(const GearPairDesign& design) {
  const gear::BevelPair pair = bevel_pair(design.settled);
  std::vector<std::string> notes;
  for (int i = 0; i < 2; ++i) {
    const gear::BevelGear own = gear::bevel_gear(pair, i);
    if (own.cone_angle < kRightAngle) continue;
    notes.push_back(fmt::format(
        "The {}'s cone angle is {:.6g}°: it would be a face gear or an internal one, to which this "
        "geometry does not apply; use a smaller shaft angle, or another ratio.",
        i == 0 ? "pinion" : "wheel", degrees(own.cone_angle)));
  }
  const double cone = gear::bevel_gear(pair, 0).cone_distance;
  if (pair.face_width >= cone) {
    notes.push_back(fmt::format(
        "The face width of {:g} reaches the apex of the cones, {:.6g} from their outer ends.",
        pair.face_width, cone));
  } else if (pair.face_width > cone / 3) {
    notes.push_back(
        fmt::format("The face width is more than a third of the cone distance {:.6g}.", cone));
  }
  if (!is_external(pair)) return notes;
  const GearConstraints& demanded = design.settled.constraints;
  for (std::size_t i = 0; i < 2; ++i) {
    const std::string name = i == 0 ? "The pinion" : "The wheel";
    const gear::BevelGear own = gear::bevel_gear(pair, static_cast<int>(i));
    const std::string undercut =
        undercut_note_of_cone(own.virtual_gear, std::cos(own.cone_angle), name);
    append(notes,
           section_notes(own.virtual_gear, allowed(undercut, !demanded.no_undercut, "no_undercut"),
                         name + "'s virtual gear"));
  }
  const auto mesh = mesh_of(design.pair);
  if (mesh) append(notes, interference_notes(design.pair, *mesh, !demanded.no_interference));
  return notes;
}

}  // namespace cognate::problems
