/// @file A finished gear pair with all that is known of it.
#pragma once

#include <optional>
#include <string>

#include "problems/gear/gear_pair_limits.hpp"
#include "problems/gear/gear_result.hpp"

namespace cognate::problems {

/// The cylindrical pair of these numbers: its facts and its checks, for `asked`.
GearPairDesign cylindrical_design(const GearPairProblem& asked, const GearPairNumbers& numbers,
                                  std::string origin);

/// Bevel gears and worms, of which everything is given.
GearPairDesign bevel_design(const GearPairProblem& asked);
GearPairDesign worm_design(const GearPairProblem& asked);

/// The check of a finished design that a demand is; a tooth's fault in words.
ConstraintCheck check_of(const GearLimit& limit);

/// What keeps bevel gears, or a worm and its wheel, from running; none where nothing does.
std::vector<std::string> bevel_notes(const GearPairDesign& design);
std::vector<std::string> worm_notes(const GearPairDesign& design);

/// Gear 0 or 1 of a settled cylindrical pair, with its own hand of helix.
gear::HelicalGear helical_gear(const GearPairProblem& settled, std::size_t index);

/// Of a pair whose contact ratio is below 1 the greatest centre distance at which it is 1, teeth
/// and shifts kept; empty where it is below 1 even without backlash.
std::optional<double> greatest_continuous_distance(const GearPairDesign& design);

}  // namespace cognate::problems
