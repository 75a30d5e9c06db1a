/// @file What a gear pair is like, in numbers.
#pragma once

#include <optional>
#include <vector>

#include "problems/gear/result.hpp"

namespace cognate::problems {

/// Of a cylindrical pair: ratio, centre distance, angle, contact ratios, backlash, sliding, and
/// each gear's own under "pinion." and "wheel.".
std::vector<Quantity> cylindrical_quantities(const GearPairDesign& design,
                                             const std::optional<gear::PairGeometry>& mesh);

/// Appends `of`.
void append(std::vector<Quantity>& quantities, const std::vector<Quantity>& of);

}  // namespace cognate::problems
