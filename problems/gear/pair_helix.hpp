/// @file The helix angle with which a helical pair has its centre distance.
#pragma once

#include <array>
#include <optional>

#include "analysis/numbers/constants.hpp"
#include "problems/gear/problem.hpp"

namespace cognate::problems {

/// The greatest helix angle that a file may have.
inline constexpr double kGreatestHelix = 80 * kPi / 180;

/// The centre distances that the teeth, module, shifts and backlash of `problem` have without helix
/// and with the greatest, not numbers where there are none; empty where these are not all given.
std::optional<std::array<double, 2>> distances_of_helices(const GearPairProblem& problem);

/// The pinion's helix angle β > 0 with which the pair has its centre distance and backlash: with no
/// sum of shifts and no backlash cos β = m_n (z₁ + z₂)/(2 a). Empty where it lies outside those
/// distances, or something but the helix is not given.
std::optional<double> helix_of_distance(const GearPairProblem& problem);

}  // namespace cognate::problems
