/// @file What has to be told of exact function generators, each by its number.
#pragma once

#include "problems/function/samples.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// Links longer than so many times the shortest are taken for the limit in which a slider takes
/// their place.
inline constexpr double kLimitingRatio = 1e3;

/// Whether the longest link of `design` is more than `kLimitingRatio` times the shortest.
bool is_limiting(const Design& design);

/// Adds sentences on the designs of `result`, in the order in which they stand there: which have a
/// start turned by 180° against the one given, which do not close over the whole range, and which
/// are at the limit of long links or near it.
void note_designs(const FunctionSamples& wanted, Result& result);

}  // namespace cognate::problems
