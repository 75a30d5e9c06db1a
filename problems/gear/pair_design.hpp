/// @file A finished gear pair with all that is known of it.
#pragma once

#include <optional>
#include <string>

#include "analysis/gear/line_of_action.hpp"
#include "problems/gear/pair_limits.hpp"
#include "problems/gear/result.hpp"

namespace cognate::problems {

/// The cylindrical pair of these numbers: its quantities and its checks, for `asked`.
GearPairDesign cylindrical_design(const GearPairProblem& asked, const GearPairNumbers& numbers,
                                  std::string origin);

/// The bevel gears of a whole problem.
gear::BevelPair bevel_pair(const GearPairProblem& problem);

/// Bevel gears and worms, of which everything is given.
GearPairDesign bevel_design(const GearPairProblem& asked);
GearPairDesign worm_design(const GearPairProblem& asked);

/// `limit` as a check of a finished design; of a tooth's fault its name instead of its number.
ConstraintCheck check_of(const GearLimit& limit);

/// What keeps bevel gears, or a worm and its wheel, from running; none where nothing does.
std::vector<std::string> bevel_notes(const GearPairDesign& design);
std::vector<std::string> worm_notes(const GearPairDesign& design);

/// Gear 0 or 1 of a settled cylindrical pair, with its own hand of helix.
gear::HelicalGear helical_gear(const GearPairProblem& settled, std::size_t index);

/// Of a pair whose contact ratio is below 1 the centre distances at which it is 1 or more, teeth
/// and shifts kept; empty where there are none.
std::optional<gear::DistanceRange> continuous_distances(const GearPairDesign& design);

}  // namespace cognate::problems
