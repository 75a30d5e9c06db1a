/// @file Random proportions of four-bars.
#pragma once

#include <optional>
#include <random>

#include "analysis/linkage/four_bar.hpp"
#include "problems/linkage/linkage_limits.hpp"

namespace cognate::problems {

/// Link lengths with crank = 1, drawn so that linkages of every proportion come up: the shortest
/// link is 1, two others are spread evenly in the logarithm up to `largest`, and the last evenly
/// between the ends of what the class allows. Without a class all kinds are drawn.
Lengths<double> random_ratios(std::mt19937_64& random, const std::optional<RequiredClass>& required,
                              double largest);

}  // namespace cognate::problems
