/// A cylindrical worm and its wheel, of which all is given.
#include "problems/basics/degrees.hpp"
#include "problems/gear/notes.hpp"
#include "problems/gear/pair_design.hpp"

namespace cognate::problems {
namespace {

constexpr const char* kWheel = "The wheel's middle section";

double least_shift(const gear::WormPair& worm) {
  return gear::least_profile_shift(worm.rack, worm.wheel_teeth);
}

/// The wheel in its middle plane, where it meshes as a spur gear does with a rack.
gear::SpurGear middle_section(const gear::WormPair& worm) {
  return {.teeth = worm.wheel_teeth,
          .module = worm.module,
          .profile_shift = worm.wheel_shift,
          .rack = worm.rack};
}

class WormDesign {
 public:
  explicit WormDesign(const GearPairProblem& asked)
      : worm_(asked.worm), geometry_(gear::geometry(worm_)), wheel_(middle_section(worm_)) {
    design_.settled = asked;
    design_.settled.centre_distance = geometry_.centre_distance;
    design_.origin = "given";
  }

  GearPairDesign made() && {
    add_quantities();
    add_worm();
    add_wheel();
    add_checks();
    return std::move(design_);
  }

 private:
  void add(const char* name, double value) { design_.metrics.push_back({name, value}); }

  void add_quantities() {
    add("ratio", worm_.wheel_teeth / worm_.starts);
    add("module", worm_.module);
    add("centre_distance", geometry_.centre_distance);
    add("normal_pressure_angle_deg", degrees(geometry_.normal_pressure_angle));
    add("sliding_speed_ratio", geometry_.sliding_speed_ratio);
    if (!design_.settled.friction) return;
    const double friction = *design_.settled.friction;
    add("efficiency", gear::efficiency(worm_, friction));
    design_.metrics.push_back({"self_locking", gear::locks_itself(worm_, friction)});
  }

  void add_worm() {
    add("worm.lead_angle_deg", degrees(geometry_.lead_angle));
    add("worm.lead", geometry_.lead);
    add("worm.reference_diameter", geometry_.worm_reference_diameter);
    add("worm.tip_diameter", geometry_.worm_tip_diameter);
    add("worm.root_diameter", geometry_.worm_root_diameter);
  }

  void add_wheel() {
    add("wheel.teeth", worm_.wheel_teeth);
    add("wheel.profile_shift", worm_.wheel_shift);
    add("wheel.reference_diameter", geometry_.wheel_reference_diameter);
    add("wheel.throat_diameter", geometry_.wheel_throat_diameter);
    add("wheel.root_diameter", geometry_.wheel_root_diameter);
    add("wheel.least_profile_shift", least_shift(worm_));
    design_.metrics.push_back({"wheel.undercut", gear::is_undercut(wheel_)});
    if (has_tip()) add("wheel.tip_thickness", tip_thickness());
  }

  /// Whether the tooth reaches beyond the base circle, inside which it has no thickness.
  bool has_tip() const { return gear::tip_radius(wheel_) >= gear::base_radius(wheel_); }
  double tip_thickness() const { return gear::tooth_thickness(wheel_, gear::tip_radius(wheel_)); }

  void at_least(const char* name, double value, double bound, double scale = 1) {
    design_.constraints.push_back(check_of({name, value, bound, true, scale}));
  }

  void add_checks() {
    at_least("root_diameter.worm", geometry_.worm_root_diameter, 0, worm_.module);
    at_least("root_diameter.wheel", geometry_.wheel_root_diameter, 0, worm_.module);
    const auto fault = gear::tooth_fault(wheel_);
    if (fault != gear::ToothFault::none) {
      design_.constraints.push_back(check_of({"teeth.wheel", double(fault), 0, false, 1}));
    }
    const auto& demanded = design_.settled.constraints;
    if (has_tip()) {
      at_least("tip_thickness_min.wheel", tip_thickness() / worm_.module,
               demanded.tip_thickness_min);
    }
    if (demanded.no_undercut) {
      at_least("no_undercut.wheel", worm_.wheel_shift, least_shift(worm_));
    }
  }

  gear::WormPair worm_;
  gear::WormGeometry geometry_;
  gear::SpurGear wheel_;
  GearPairDesign design_;
};

}  // namespace

GearPairDesign worm_design(const GearPairProblem& asked) {
  return WormDesign(asked).made();
}

std::vector<std::string> worm_notes(const GearPairDesign& design) {
  const gear::WormPair& worm = design.settled.worm;
  const gear::SpurGear wheel = middle_section(worm);
  std::vector<std::string> notes;
  if (gear::geometry(worm).worm_root_diameter <= 0) {
    notes.emplace_back("The worm's teeth reach beyond its axis; use a greater diameter_quotient.");
  }
  if (gear::root_radius(wheel) <= 0) {
    notes.emplace_back(
        "The wheel's teeth reach beyond its axis; use more of them, or a greater wheel_shift.");
    return notes;
  }
  const std::string undercut = undercut_note(wheel, least_shift(worm), kWheel);
  const auto own = section_notes(
      wheel, allowed(undercut, !design.settled.constraints.no_undercut, "no_undercut"), kWheel);
  notes.insert(notes.end(), own.begin(), own.end());
  return notes;
}

}  // namespace cognate::problems
