/// @file Dimensions drawn from their tolerances.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "problems/tolerance/dimensions.hpp"
#include "problems/tolerance/tolerances.hpp"

namespace cognate::problems {

/// The standard normal number below which a share `p` in (0, 1) lies, to 1e-15 (Wichura, algorithm
/// AS 241, 1988).
double normal_quantile(double p);

/// Standard deviations in half the width of a tolerance.
double deviations_in_half_width(ToleranceDistribution distribution);

/// changes[d·count + i] of dimension d in sample first + i: a function of seed, d and the sample's
/// number alone.
void draw_changes(std::span<const TolerancedDimension> dimensions,
                  ToleranceDistribution distribution, std::uint64_t seed, std::size_t first,
                  std::size_t count, std::span<double> changes);

/// Not a number in place of each of these changes that leaves nothing of a length, as the tails of
/// a normal distribution may: such a sample cannot be assembled.
void reject_lost_lengths(std::span<const TolerancedDimension> dimensions, std::size_t count,
                         std::span<double> changes);

}  // namespace cognate::problems
