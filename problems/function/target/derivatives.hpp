/// @file Derivatives of a function that can only be evaluated.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "problems/linkage/linkage_limits.hpp"

namespace cognate::problems {

struct Derivative {
  double value = 0;
  double relative_error = 0;  ///< estimated, relative to the derivative or, where that is small, to
                              ///< the function's change over the window; 1 where it has none
};

/// The first `count` derivatives of `f` at `x`, `f` being evaluated on `domain` alone.
///
/// Those of the polynomial through Chebyshev's points of the widest window about x (beside it where
/// the domain ends there) in which 25 points resolve f to rounding. Of a function as smooth as a
/// logarithm the fourth derivative is then good to 1e-10 inside its domain, to 1e-6 at the ends;
/// the first to 1e-13. Where no window down to a hundredth of the domain resolves f, as at a
/// corner, the errors are 1.
std::vector<Derivative> derivatives(const std::function<double(double)>& f, double x,
                                    const Range& domain, std::size_t count);

}  // namespace cognate::problems
