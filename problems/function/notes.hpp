/// @file What has to be said of any function generator: dead points on its way, jumps of its
/// target.
#pragma once

#include "problems/function/problem.hpp"
#include "problems/function/samples.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// A transmission angle nearer to 0 or 180° than this, in radians, is that of a dead point.
inline constexpr double kDeadTransmission = 1e-3;

/// Adds sentences on the designs of `result`, in the order in which they stand there, that pass or
/// reach a dead point or a change point, on a function that jumps within its domain, and on pairs
/// that scatter.
void note_motions(const FunctionProblem& problem, const FunctionSamples& wanted, Result& result);

}  // namespace cognate::problems
