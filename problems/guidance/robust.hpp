/// @file Body guidance by four-bars that minds its tolerances least.
#pragma once

#include "problems/guidance/problem.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// The nominal optimum and other minima, and from these the designs for which a quantile over the
/// tolerances, or the worst case, of the greatest error over the poses is least: that of a pose is
/// the root of |Δp|² + (angle weight · Δθ)². The crank follows in what is made, but for the ends of
/// a motion between which a transmission angle is limited. The front as `add_robust` gives it.
Result solve_motion_robustly(const MotionProblem& problem, const Run& run,
                             const Deadline& deadline);

}  // namespace cognate::problems
