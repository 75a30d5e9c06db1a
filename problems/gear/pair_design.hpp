/// @file A finished gear pair with all that is known of it.
#pragma once

#include <optional>
#include <string>

#include "analysis/gear/internal_pair.hpp"
#include "analysis/gear/line_of_action.hpp"
#include "analysis/gear/rack_pair.hpp"
#include "problems/gear/pair_limits.hpp"
#include "problems/gear/result.hpp"

namespace cognate::problems {

/// The cylindrical pair of these numbers: its quantities and its checks, for `asked`.
GearPairDesign cylindrical_design(const GearPairProblem& asked, const GearPairNumbers& numbers,
                                  std::string origin);

/// The bevel gears of a whole problem.
gear::BevelPair bevel_pair(const GearPairProblem& problem);

/// The pinion and the ring, or the pinion and the rack, of a whole problem, at the distance that is
/// given or has its backlash.
gear::InternalPair internal_pair(const GearPairProblem& problem);
gear::RackPair rack_pair(const GearPairProblem& problem);

/// Bevel gears, worms, pinions in rings and on racks, of which everything is given.
GearPairDesign bevel_design(const GearPairProblem& asked);
GearPairDesign worm_design(const GearPairProblem& asked);
GearPairDesign internal_design(const GearPairProblem& asked);
GearPairDesign rack_design(const GearPairProblem& asked);

/// `limit` as a check of a finished design; of a tooth's fault its name instead of its number.
ConstraintCheck check_of(const GearLimit& limit);

/// The checks of a mesh that is not two external gears: backlash, contact ratio, sliding, and of
/// each member, "pinion" first, its interference and tip clearance.
void add_mesh_checks(const gear::PairGeometry& mesh, const char* partner, GearPairDesign& design);
/// Those of the pinion's teeth: whether they can be made, tip thickness, undercut.
void add_pinion_checks(const gear::SpurGear& pinion, GearPairDesign& design);
/// The quantities of such a mesh.
void add_mesh_quantities(const gear::PairGeometry& mesh, GearPairDesign& design);

/// What keeps such pairs from running; none where nothing does.
std::vector<std::string> bevel_notes(const GearPairDesign& design);
std::vector<std::string> worm_notes(const GearPairDesign& design);
std::vector<std::string> internal_notes(const GearPairDesign& design);
std::vector<std::string> rack_notes(const GearPairDesign& design);
/// The notes that both have of their mesh.
std::vector<std::string> mesh_notes(const gear::PairGeometry& mesh, const char* partner,
                                    const GearPairDesign& design);

/// Gear 0 or 1 of a settled cylindrical pair, with its own hand of helix.
gear::HelicalGear helical_gear(const GearPairProblem& settled, std::size_t index);

/// Of a pair whose contact ratio is below 1 the centre distances at which it is 1 or more, teeth
/// and shifts kept; empty where there are none.
std::optional<gear::DistanceRange> continuous_distances(const GearPairDesign& design);

}  // namespace cognate::problems
