/// @file Real roots of homogeneous polynomials in two unknowns: directions rather than ratios, so
/// that a root at infinity is a root like any other.
#pragma once

#include <array>

#include "analysis/numbers/vec2.hpp"
#include "synthesis/exact/in_place_vector.hpp"

namespace cognate::synthesis {

/// The real directions (α, β), of unit length and up to sign, in which c₀α² + c₁αβ + c₂β² is zero:
/// none, or two that fall together where the discriminant is zero to within rounding. None where
/// all coefficients are zero.
InPlaceVector<Vec2d, 2> real_roots(const std::array<double, 3>& c);

/// As above for c₀α³ + c₁α²β + c₂αβ² + c₃β³: one or three. A double root comes out twice, and so
/// does a pair of complex roots that rounding may have split off one.
InPlaceVector<Vec2d, 3> real_roots(const std::array<double, 4>& c);

/// The coefficients of b(v, v) with v = αu + βw, b linear in each of its arguments.
template <class Vector, class Form>
std::array<double, 3> quadratic_form(const Form& b, const Vector& u, const Vector& w) {
  return {b(u, u), b(u, w) + b(w, u), b(w, w)};
}

/// The coefficients of t(v, v, v) with v = αu + βw, t linear in each of its arguments.
template <class Vector, class Form>
std::array<double, 4> cubic_form(const Form& t, const Vector& u, const Vector& w) {
  return {t(u, u, u), t(u, u, w) + t(u, w, u) + t(w, u, u), t(u, w, w) + t(w, u, w) + t(w, w, u),
          t(w, w, w)};
}

}  // namespace cognate::synthesis
