/// @file Second derivatives of the cosine of a four-bar's transmission angle.
#pragma once

#include <array>

#include "analysis/linkage/four_bar.hpp"

namespace cognate::problems {

/// By crank, coupler, rocker, frame and crank angle, in this order; symmetric.
using TransmissionHessian = std::array<std::array<double, 5>, 5>;

/// Of cos μ = (l₂² + l₃² − d²)/(2 l₂ l₃) with d² = l₁² + l₄² − 2 l₁ l₄ cos θ.
TransmissionHessian transmission_hessian(const Lengths<double>& links, double cosine, double sine);

}  // namespace cognate::problems
