/// @file The least value of a quadratic over a box, from below.
#pragma once

#include <array>

#include "synthesis/bounds/proportion_box.hpp"

namespace cognate::synthesis {

/// Coefficients of Σ c(a, b) t_a t_b with t_0 = 1 and a, b from 0 to 4; symmetric.
using BoxQuadratic = std::array<std::array<double, kBoxSides + 1>, kBoxSides + 1>;

/// No more than the least value over t_1…t_4 in [−1, 1], less what rounding may hide; the least
/// value itself, up to rounding, where the quadratic is convex. A form that is not is made so by
/// adding a multiple of t², whose greatest value is taken off again. Rows of zeros cost nothing.
double least_over_box(const BoxQuadratic& quadratic);

}  // namespace cognate::synthesis
