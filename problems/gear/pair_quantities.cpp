#include "problems/gear/pair_quantities.hpp"

#include <cmath>

#include "problems/basics/degrees.hpp"
#include "problems/gear/pair_design.hpp"
#include "problems/gear/quantities.hpp"

namespace cognate::problems {
namespace {

class PairQuantities {
 public:
  PairQuantities(const GearPairDesign& design, const std::optional<gear::PairGeometry>& mesh)
      : design_(design), settled_(design.settled), mesh_(mesh) {}

  std::vector<Quantity> all() && {
    const auto& [pinion, wheel] = design_.pair.gears;
    add("ratio", wheel.teeth / pinion.teeth);
    add("module", *settled_.module);
    if (settled_.helix != 0) add("helix_deg", degrees(settled_.helix));
    add("centre_distance", design_.pair.centre_distance);
    add("reference_centre_distance",
        gear::reference_radius(pinion) + gear::reference_radius(wheel));
    add("profile_shift_sum", *settled_.profile_shift[0] + *settled_.profile_shift[1]);
    add("zero_backlash_distance", gear::centre_distance_without_backlash(design_.pair.gears));
    if (mesh_) add_mesh();
    add_gear(0, "pinion.");
    add_gear(1, "wheel.");
    return std::move(quantities_);
  }

 private:
  void add(const std::string& name, double value) { quantities_.push_back({name, value}); }

  void add_mesh() {
    const double module = *settled_.module;
    add("working_pressure_angle_deg", degrees(mesh_->working_pressure_angle));
    add("contact_ratio", mesh_->contact_ratio);
    if (settled_.helix != 0) {
      const double total = total_contact_ratio(settled_, module, *mesh_);
      add("overlap_ratio", total - mesh_->contact_ratio);
      add("total_contact_ratio", total);
    }
    add("path_length", mesh_->path_length);
    add("approach_length", mesh_->approach);
    add("recess_length", mesh_->recess);
    add("backlash", mesh_->backlash);
    // Across helical teeth that along the line of action is shorter (ISO 21771).
    const double base_helix = gear::base_helix(helical_gear(settled_, 0));
    add("normal_backlash", mesh_->normal_backlash * std::cos(base_helix));
    add("sliding_max", greatest_sliding(*mesh_));
    add("sliding_speed_ratio_max", mesh_->greatest_sliding_speed);
    if (total_contact_ratio(settled_, module, *mesh_) >= 1) return;
    const auto distances = continuous_distances(design_);
    if (distances) add("continuous_centre_distance_max", distances->greatest);
  }

  void add_gear(std::size_t index, const std::string& prefix) {
    quantities_.push_back({prefix + "teeth", design_.pair.gears[index].teeth});
    append(quantities_, gear_quantities(helical_gear(settled_, index), prefix));
    if (!mesh_) return;
    const auto& own = mesh_->gears[index];
    add(prefix + "working_diameter", 2 * own.working_radius);
    add(prefix + "contact_start_diameter", 2 * own.contact_start);
    add(prefix + "contact_end_diameter", 2 * own.contact_end);
    add(prefix + "tip_clearance", own.tip_clearance);
    add(prefix + "sliding_start", own.sliding_start);
    add(prefix + "sliding_end", own.sliding_end);
    quantities_.push_back({prefix + "interferes", own.interference > 0});
  }

  const GearPairDesign& design_;
  const GearPairProblem& settled_;
  const std::optional<gear::PairGeometry>& mesh_;
  std::vector<Quantity> quantities_;
};

}  // namespace

std::vector<Quantity> cylindrical_quantities(const GearPairDesign& design,
                                             const std::optional<gear::PairGeometry>& mesh) {
  return PairQuantities(design, mesh).all();
}

void append(std::vector<Quantity>& quantities, const std::vector<Quantity>& of) {
  quantities.insert(quantities.end(), of.begin(), of.end());
}

}  // namespace cognate::problems
