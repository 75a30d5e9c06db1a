/// @file Where a homogeneous quartic in two variables changes its sign.
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>

#include "synthesis/exact/in_place_vector.hpp"

namespace cognate::synthesis {

/// Σ cₖ x^{n−k} yᵏ, n + 1 coefficients.
double binary_form(std::span<const double> c, const Eigen::Vector2d& at);

/// Angles of directions (x, y), in [0, π) and ascending order.
struct SignsOfQuartic {
  InPlaceVector<double, 4> changes;  ///< where the form changes its sign
  InPlaceVector<double, 2> touches;  ///< double roots, within rounding, between values of one sign
};

/// The eigenvalues of the companion matrix show where to look, bisection finds the changes.
SignsOfQuartic signs_of(const std::array<double, 5>& c);

}  // namespace cognate::synthesis
