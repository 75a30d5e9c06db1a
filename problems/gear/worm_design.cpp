/// A cylindrical worm and its wheel, of which all is given.
#include <fmt/core.h>

#include <cmath>

#include "problems/degrees.hpp"
#include "problems/gear/gear_pair_design.hpp"

namespace cognate::problems {
namespace {

double least_shift(const gear::WormPair& worm) {
  return gear::least_profile_shift(worm.rack, worm.wheel_teeth);
}

class WormDesign {
 public:
  explicit WormDesign(const GearPairProblem& asked)
      : worm_(asked.worm), geometry_(gear::geometry(worm_)) {
    design_.settled = asked;
    design_.settled.centre_distance = geometry_.centre_distance;
    design_.origin = "given";
  }

  GearPairDesign made() && {
    add_facts();
    add_worm();
    add_wheel();
    add_checks();
    return std::move(design_);
  }

 private:
  void add(const char* name, double value) { design_.metrics.push_back({name, value}); }

  void add_facts() {
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
    const bool undercut = worm_.wheel_shift < least_shift(worm_) - 1e-12;
    design_.metrics.push_back({"wheel.undercut", undercut});
  }

  void at_least(const char* name, double value, double bound, double scale = 1) {
    design_.constraints.push_back(check_of({name, value, bound, true, scale}));
  }

  void add_checks() {
    at_least("root_diameter.worm", geometry_.worm_root_diameter, 0, worm_.module);
    at_least("root_diameter.wheel", geometry_.wheel_root_diameter, 0, worm_.module);
    if (design_.settled.constraints.no_undercut) {
      at_least("no_undercut.wheel", worm_.wheel_shift, least_shift(worm_));
    }
  }

  gear::WormPair worm_;
  gear::WormGeometry geometry_;
  GearPairDesign design_;
};

}  // namespace

GearPairDesign worm_design(const GearPairProblem& asked) {
  return WormDesign(asked).made();
}

std::vector<std::string> worm_notes(const GearPairDesign& design) {
  const gear::WormPair& worm = design.settled.worm;
  std::vector<std::string> notes;
  if (worm.wheel_shift < least_shift(worm) - 1e-12) {
    notes.push_back(
        fmt::format("The wheel is undercut in the middle plane: {:g} teeth need a shift "
                    "of at least {:.4f}.",
                    worm.wheel_teeth, least_shift(worm)));
  }
  const auto geometry = gear::geometry(worm);
  if (geometry.worm_root_diameter <= 0 || geometry.wheel_root_diameter <= 0) {
    notes.emplace_back(
        "The teeth reach beyond the axis; a greater diameter_quotient, or more "
        "teeth, is wanted.");
  }
  return notes;
}

}  // namespace cognate::problems
