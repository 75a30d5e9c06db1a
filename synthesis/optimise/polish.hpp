/// @file The last digits of sums of squares that vanish, or nearly so, at their minimum.
#pragma once

#include <vector>

#include "synthesis/optimise/model.hpp"
#include "synthesis/optimise/solver.hpp"

namespace cognate::synthesis {

/// Levenberg–Marquardt steps from `start` by orthogonal factors of the Jacobian, not by JᵀJ, whose
/// condition is that of J squared: in a flat valley normal equations end where |r| is the root of
/// rounding, these go on to rounding itself. Worth it where the residuals are small; elsewhere the
/// sum of squares is flat to its last digits long before.
///
/// `model` has no local variables and a sum of squares for its objective. Points beyond bounds are
/// brought back to them; no point is taken that is worse, or that violates the constraints by more
/// than `options.feasibility` and more than the start. Stops as the options say, and where a
/// solution would not change but for rounding.
Solution polish(const Model& model, std::vector<double> start, const Options& options);

}  // namespace cognate::synthesis
