/// @file How a whole coupler curve follows a closed curve.
#pragma once

#include "analysis/linkage/four_bar.hpp"
#include "problems/linkage/result.hpp"
#include "problems/path/curve/closed_curve.hpp"

namespace cognate::problems {

/// The greatest distance of the coupler curve of `linkage`, over the full turn, from `curve` at
/// `placement`, in the curve's own unit. Errors at samples of the curve bound the distance of the
/// curve from the coupler curve; this is the other half of Hausdorff's distance. The crank is
/// looked at in so many positions.
double curve_deviation(const ClosedCurve& curve, const FourBar& linkage,
                       const CurvePlacement& placement, int positions = 720);

/// Whether a coupler curve with this deviation follows a curve whose samples it meets within
/// `error_max`: else it runs through a loop of its own between two of them.
ConstraintCheck check_extra_loop(const ClosedCurve& curve, double deviation, double error_max);

}  // namespace cognate::problems
