/// @file Motion generation by least squares, from problem to designs.
#pragma once

#include "problems/guidance/problem.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// Designs with least Σ |Δp|² + (angle weight · Δθ)² over the poses, each pose at the crank angle
/// that suits it best. Of designs that meet the poses to rounding the better transmission angle
/// comes first.
Result solve_by_least_squares(const MotionProblem& problem, const Run& run);

}  // namespace cognate::problems
