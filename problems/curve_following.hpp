/// @file How a whole coupler curve follows a closed curve.
#pragma once

#include "problems/problem.hpp"
#include "problems/result.hpp"

namespace cognate::problems {

/// Where the target is a closed curve, adds its length to the facts of `result`, and to the metrics
/// of each design `curve_deviation_max`: the greatest distance of its coupler curve, over the full
/// turn, from the target, in the target's own unit. Errors are those of samples of the target
/// alone: they do not see a loop of the coupler curve between two of them. Where there may be one,
/// a note says so.
void tell_following(const PathProblem& problem, Result& result);

}  // namespace cognate::problems
