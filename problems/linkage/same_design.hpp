/// @file Compares designs, so that equal ones are reported once.
#pragma once

#include "analysis/linkage/four_bar.hpp"

namespace cognate::problems {

/// Whether two linkages agree in assembly, and in pivots, links and coupler point to within
/// `tolerance` times the larger of their longest links and coupler point radii.
bool same_design(const FourBar& a, const FourBar& b, double tolerance);

/// Whether `b` is another linkage that traces the coupler curve of `a`: a Roberts cognate, or `a`
/// or one of its cognates driven from the other end. Where the driving link is another than that
/// of `a`, the assembly may change along the curve and is not compared. False without coupler
/// points.
bool is_cognate(const FourBar& a, const FourBar& b, double tolerance);

}  // namespace cognate::problems
