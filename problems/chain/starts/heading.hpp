/// @file How a body that follows a path lies in its link, where its angles count too.
#pragma once

#include <span>

#include "problems/chain/scaled.hpp"

namespace cognate::problems {

/// Turns the body in its link so that its directions at the targets `which`, where the crank has
/// the angles `cranks`, are nearest to those wanted. Returns the mean square of what is left, as a
/// length; not a number where the chain does not close.
double turn_body(const ScaledChain& problem, std::span<const std::size_t> which,
                 std::span<const double> cranks, synthesis::ChainDesign& design);

}  // namespace cognate::problems
