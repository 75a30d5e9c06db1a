/// @file Linear systems of eight complex unknowns, one in each lane, by elimination with pivots
/// chosen in each lane for itself. Include in the kernel alone.
#pragma once

#include "synthesis/exact/nine_point/numbers.hpp"
#include "synthesis/exact/nine_point/track_kernel.hpp"

namespace cognate::synthesis::nine_point::COGNATE_ISA {

/// Rows come with largest entries of like size. A singular system gives infinities and NaN.
class Elimination {
 public:
  static constexpr int kSize = kPivots;

  Complex rows[kSize][kSize];

  /// Replaces the rows by their factors.
  void factor() {
    for (int k = 0; k < kSize; ++k) {
      Real best = size(rows[k][k]);
      for (int i = k + 1; i < kSize; ++i) {
        const Real other = size(rows[i][k]);
        const Mask swap = other > best;
        best = larger(other, best);
        swap_[k][i] = swap;
        for (int j = k; j < kSize; ++j) exchange(swap, rows[k][j], rows[i][j]);
      }
      inverse_pivot_[k] = inverse(rows[k][k]);
      for (int i = k + 1; i < kSize; ++i) {
        const Complex factor = rows[i][k] * inverse_pivot_[k];
        rows[i][k] = factor;
        for (int j = k + 1; j < kSize; ++j) {
          rows[i][j] = subtract_product(rows[i][j], factor, rows[k][j]);
        }
      }
    }
  }

  /// Replaces the right side by the solution.
  void solve(Complex (&x)[kSize]) const {
    for (int k = 0; k < kSize; ++k) {
      for (int i = k + 1; i < kSize; ++i) exchange(swap_[k][i], x[k], x[i]);
      for (int i = k + 1; i < kSize; ++i) x[i] = subtract_product(x[i], rows[i][k], x[k]);
    }
    for (int k = kSize - 1; k >= 0; --k) {
      x[k] = x[k] * inverse_pivot_[k];
      for (int i = 0; i < k; ++i) x[i] = subtract_product(x[i], rows[i][k], x[k]);
    }
  }

 private:
  static void exchange(const Mask& swap, Complex& a, Complex& b) {
    const Complex old = a;
    a = choose(swap, b, a);
    b = choose(swap, old, b);
  }

  Complex inverse_pivot_[kSize];
  Mask swap_[kSize][kSize];
};

}  // namespace cognate::synthesis::nine_point::COGNATE_ISA
