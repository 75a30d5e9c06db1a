/// @file Conditions on a four-bar beside its positions: a pivot or a length that is given.
#pragma once

#include <array>
#include <complex>

#include "synthesis/exact/nine_point/path_equations.hpp"

namespace cognate::synthesis {

/// The unknowns of a four-bar in the order x, x̄, a, ā, y, ȳ, b, b̄: moving and fixed pivot of the
/// first dyad, then of the second, each with its conjugate.
inline constexpr int kPivotUnknowns = 8;

template <class C>
using PivotUnknowns = std::array<C, kPivotUnknowns>;

template <class C>
PivotUnknowns<C> pivot_unknowns(const Dyad<C>& first, const Dyad<C>& second) {
  return {first.moving,  first.moving_bar,  first.fixed,  first.fixed_bar,
          second.moving, second.moving_bar, second.fixed, second.fixed_bar};
}

/// The condition Σ linear[i] u[i] + (u[from] − u[to])(u[from+1] − u[to+1]) = value; the product,
/// the square of the distance of two pivots, is left out where `from` is negative.
template <class Real>
struct SideConditionOf {
  std::array<std::complex<Real>, kPivotUnknowns> linear{};
  std::complex<Real> value;
  int from = -1, to = -1;  ///< even places in the unknowns
};
using SideCondition = SideConditionOf<double>;

/// The left side less the right.
template <class C, class Real>
C side_value(const SideConditionOf<Real>& condition, const PivotUnknowns<C>& u) {
  C sum = C(-condition.value);
  for (std::size_t i = 0; i < u.size(); ++i) {
    if (condition.linear[i] != std::complex<Real>(0)) sum = sum + C(condition.linear[i]) * u[i];
  }
  if (condition.from >= 0) {
    const auto p = std::size_t(condition.from), q = std::size_t(condition.to);
    sum = sum + (u[p] - u[q]) * (u[p + 1] - u[q + 1]);
  }
  return sum;
}

/// Its partial derivatives.
template <class C, class Real>
PivotUnknowns<C> side_gradient(const SideConditionOf<Real>& condition, const PivotUnknowns<C>& u) {
  PivotUnknowns<C> gradient;
  for (std::size_t i = 0; i < u.size(); ++i) gradient[i] = C(condition.linear[i]);
  if (condition.from >= 0) {
    const auto p = std::size_t(condition.from), q = std::size_t(condition.to);
    const C along = u[p] - u[q], along_bar = u[p + 1] - u[q + 1];
    gradient[p] = gradient[p] + along_bar;
    gradient[q] = gradient[q] - along_bar;
    gradient[p + 1] = gradient[p + 1] + along;
    gradient[q + 1] = gradient[q + 1] - along;
  }
  return gradient;
}

}  // namespace cognate::synthesis
