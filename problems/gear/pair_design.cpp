#include "problems/gear/pair_design.hpp"

#include <algorithm>
#include <utility>

#include "problems/gear/pair_quantities.hpp"

namespace cognate::problems {
namespace {

GearPairProblem settled(GearPairProblem problem, const GearPairNumbers& numbers) {
  for (std::size_t i = 0; i < 2; ++i) {
    problem.teeth[i] = numbers.teeth[i];
    problem.profile_shift[i] = numbers.shift[i];
  }
  problem.module = numbers.module;
  problem.centre_distance = numbers.centre_distance;
  problem.backlash.reset();
  problem.free_helix = false;
  return problem;
}

}  // namespace

gear::HelicalGear helical_gear(const GearPairProblem& settled, std::size_t index) {
  gear::HelicalGear gear;
  gear.normal.teeth = settled.teeth[index].value_or(0);
  gear.normal.module = settled.module.value_or(1);
  gear.normal.profile_shift = settled.profile_shift[index].value_or(0);
  gear.normal.rack = settled.rack;
  gear.normal.tip_reduction = settled.tip_reduction[index];
  gear.helix = index == 0 ? settled.helix : -settled.helix;
  gear.face_width = settled.face_width;
  return gear;
}

GearPairDesign cylindrical_design(const GearPairProblem& asked, const GearPairNumbers& numbers,
                                  std::string origin) {
  GearPairDesign design;
  design.pair = section_of(asked, numbers);
  design.settled = settled(asked, numbers);
  const auto mesh = mesh_of(design.pair);
  design.metrics = cylindrical_quantities(design, mesh);
  const GearLimits limits(asked, numbers, design.pair, mesh);
  std::ranges::transform(limits.all(), std::back_inserter(design.constraints), check_of);
  design.origin = std::move(origin);
  return design;
}

std::optional<gear::DistanceRange> continuous_distances(const GearPairDesign& design) {
  const double overlap = overlap_of(design.settled, *design.settled.module);
  return gear::distances_in_contact(design.pair.gears, 1 - overlap);
}

}  // namespace cognate::problems
