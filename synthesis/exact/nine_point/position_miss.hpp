/// @file By how much a linkage misses a position.
#pragma once

#include <cmath>
#include <complex>

#include "synthesis/exact/nine_point/path_equations.hpp"

namespace cognate::synthesis {

/// The larger of the two; not a number where either is none, so that no bound is lost.
inline double larger(double a, double b) {
  return b <= a ? a : (std::isnan(a) ? a : b);
}

/// The least change of a displacement that takes both dyads' equations away, to first order:
/// √((|δd|² + |δd̄|²)/2), which is the distance by which the coupler of a real linkage misses its
/// point. Where the orientation is `given`, both equations have to hold; else the rotation gives
/// way and q f − p g = 0 is left of them, with p = t ∂f/∂t and q = t ∂g/∂t. `f_value` and `g_value`
/// may have more digits than `f.value` and `g.value`, which are not read. Not a number where the
/// position says nothing of the linkage.
inline double position_miss(const DyadEquation<std::complex<double>>& f,
                            const DyadEquation<std::complex<double>>& g,
                            std::complex<double> f_value, std::complex<double> g_value,
                            bool given) {
  double squares;
  if (given) {
    squares = (std::norm(f_value * g.d_bar - g_value * f.d_bar) +
               std::norm(f.d * g_value - g.d * f_value)) /
              std::norm(f.d * g.d_bar - f.d_bar * g.d);
  } else {
    const std::complex<double> p = f.log_t, q = g.log_t;
    squares = std::norm(q * f_value - p * g_value) /
              (std::norm(q * f.d - p * g.d) + std::norm(q * f.d_bar - p * g.d_bar));
  }
  return std::sqrt(squares / 2);
}

}  // namespace cognate::synthesis
