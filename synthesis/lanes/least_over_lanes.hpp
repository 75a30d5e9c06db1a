/// @file The least value of a quadratic over [−1, 1]⁴ from below, one in each lane, as in
/// box_quadratic.hpp. Include in kernels alone.
#pragma once

#include "synthesis/lanes/lane_numbers.hpp"

namespace cognate::synthesis::COGNATE_ISA {

/// constant + 2 slope·t + tᵀ A t, of A the lower triangle.
struct LanesQuadratic {
  Real constant, slope[4], a[4][4];

  const Real& form(int i, int j) const { return i < j ? a[j][i] : a[i][j]; }
};

/// Pivots below the first share of their column are raised to the second.
inline constexpr double kLeastPivot = 0.1, kRaisedPivot = 0.7;

/// Shifts of A's diagonal that make it positive semidefinite, by LDLᵀ: a pivot that is too small is
/// raised to a share of its column.
inline void convex_shifts(const LanesQuadratic& q, const Real& size, Real* shift) {
  Real a[4][4];
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j <= i; ++j) a[i][j] = q.a[i][j];
  }
  const Real least = size * Real(1e-14) + Real(1e-290);
  for (int k = 0; k < 4; ++k) {
    Real column(0.0);
    for (int i = k + 1; i < 4; ++i) column = larger(column, magnitude(a[i][k]));
    const Real small = larger(least, Real(kLeastPivot) * column);
    const Real raised = larger(least, Real(kRaisedPivot) * column);
    const Real pivot = choose(a[k][k] > small, a[k][k], raised);
    shift[k] = pivot - a[k][k];
    const Real inverse = Real(1.0) / pivot;
    for (int i = k + 1; i < 4; ++i) {
      const Real factor = a[i][k] * inverse;
      for (int j = k + 1; j <= i; ++j) a[i][j] = a[i][j] - factor * a[j][k];
    }
  }
}

/// The least value over the box: no more than it, and about what it is.
struct LanesLeast {
  Real bound, about;
};

/// Ends early where the least value is surely above or not above `wanted` in all lanes. What is
/// found in one lane does not depend on the others.
inline LanesLeast least_over_box(const LanesQuadratic& q, const Real& wanted, int most_sweeps) {
  Real size = magnitude(q.constant), shift[4], shifts(0.0), diagonal[4], inverse[4], t[4];
  for (int i = 0; i < 4; ++i) {
    size = size + Real(2.0) * magnitude(q.slope[i]) + magnitude(q.a[i][i]);
    for (int j = 0; j < i; ++j) size = size + Real(2.0) * magnitude(q.a[i][j]);
  }
  convex_shifts(q, size, shift);
  for (int i = 0; i < 4; ++i) {
    shifts = shifts + shift[i];
    diagonal[i] = q.a[i][i] + shift[i];
    inverse[i] = Real(1.0) / diagonal[i];
    t[i] = Real(0.0);
  }
  const Real lost = shifts + Real(1e-13) * (size + shifts);
  LanesLeast least{Real(-1e300), Real(0.0)};
  Mask open = least.bound < least.about;  // in all lanes
  for (int sweep = 0; sweep < most_sweeps;) {
    for (int inner = 0; inner < 4; ++inner, ++sweep) {
      for (int i = 0; i < 4; ++i) {
        Real pull = q.slope[i];
        for (int k = 0; k < 4; ++k) {
          if (k != i) pull = pull + q.form(i, k) * t[k];
        }
        t[i] = smaller(Real(1.0), larger(Real(-1.0), -pull * inverse[i]));
      }
    }
    // Any t gives a bound by the tangent there.
    Real value = q.constant, below(0.0);
    for (int i = 0; i < 4; ++i) {
      Real half_slope = q.slope[i] + diagonal[i] * t[i];
      for (int k = 0; k < 4; ++k) {
        if (k != i) half_slope = half_slope + q.form(i, k) * t[k];
      }
      value = value + (q.slope[i] + half_slope) * t[i];
      below = below + half_slope * t[i] + magnitude(half_slope);
    }
    least.bound = choose(open, larger(least.bound, value - Real(2.0) * below - lost), least.bound);
    least.about = choose(open, value - lost, least.about);
    open = open && least.bound < wanted;
    constexpr int kFewSweeps = 12;
    if (sweep >= kFewSweeps) open = open && least.about >= wanted;
    if (!any(open)) break;
  }
  return least;
}

}  // namespace cognate::synthesis::COGNATE_ISA
