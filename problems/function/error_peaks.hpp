/// @file Where the error of a function generator is greatest, between samples too.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "problems/function/samples.hpp"

namespace cognate::problems {

/// Crank angles at which a linkage may be at or near a dead point are critical if its transmission
/// angle there is nearer to 0 or 180° than this, in radians: the output then turns much while the
/// input turns little.
inline constexpr double kNearDeadPoint = 0.3;

/// The pairs of the domain where |`error`| is greatest locally and at least half of what it is
/// anywhere. The domain is looked at in `kRangeSteps` equal steps, in shorter ones where the
/// function is fast, and, about each of the inputs `critical`, in steps that halve down to a 2⁻³⁰th
/// of those; each peak is then refined. Empty for angle pairs. `error` is in the unit of the
/// output.
std::vector<synthesis::AnglePair> error_peaks(
    const std::function<double(const synthesis::AnglePair&)>& error, const FunctionSamples& wanted,
    std::span<const double> critical);

}  // namespace cognate::problems
