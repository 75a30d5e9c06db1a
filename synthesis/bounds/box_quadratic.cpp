#include "synthesis/bounds/box_quadratic.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cognate::synthesis {
namespace {

constexpr int kSize = kBoxSides;
constexpr double kQuadraticRounding = 64 * std::numeric_limits<double>::epsilon();

/// Whether the form in t_1…t_4 plus `shift`·t² is positive semidefinite beyond doubt: Cholesky's
/// factorisation runs through with room for its own rounding.
bool is_convex(const BoxQuadratic& c, double shift) {
  double root[kSize][kSize] = {};
  for (int i = 0; i < kSize; ++i) {
    for (int j = 0; j <= i; ++j) {
      double rest = c[i + 1][j + 1] + (i == j ? shift : 0);
      for (int k = 0; k < j; ++k) rest -= root[i][k] * root[j][k];
      if (i == j) {
        if (!(rest > 0)) return false;
        root[i][i] = std::sqrt(rest);
      } else {
        root[i][j] = rest / root[j][j];
      }
    }
  }
  return true;
}

}  // namespace

double least_over_box(const BoxQuadratic& c) {
  double size = 0;  // bounds every sum below
  double trace = 0;
  for (int a = 0; a <= kSize; ++a) {
    for (int b = 0; b <= kSize; ++b) size += std::abs(c[a][b]);
    if (a > 0) trace += std::abs(c[a][a]);
  }
  if (!std::isfinite(size)) return -std::numeric_limits<double>::infinity();
  // The shift that Cholesky's rounding needs is added and taken off as well.
  double shift = kQuadraticRounding * trace + std::numeric_limits<double>::min();
  while (!is_convex(c, shift - kQuadraticRounding * trace)) shift *= 4;

  // Any t gives a bound by the tangent there; the closer to the minimum the better.
  std::array<double, kSize> t{};
  for (int sweep = 0; sweep < 40; ++sweep) {
    double moved = 0;
    for (int i = 0; i < kSize; ++i) {
      double pull = c[i + 1][0];
      for (int k = 0; k < kSize; ++k) {
        if (k != i) pull += c[i + 1][k + 1] * t[k];
      }
      const double to = std::clamp(-pull / (c[i + 1][i + 1] + shift), -1.0, 1.0);
      moved = std::max(moved, std::abs(to - t[i]));
      t[i] = to;
    }
    if (moved < 1e-9) break;
  }
  double value = c[0][0];
  for (int i = 0; i < kSize; ++i) {
    double half_slope = c[i + 1][0] + shift * t[i];
    for (int k = 0; k < kSize; ++k) half_slope += c[i + 1][k + 1] * t[k];
    value += c[i + 1][0] * t[i] + half_slope * t[i];
    value -= 2 * (half_slope * t[i] + std::abs(half_slope));
  }
  return value - kSize * shift - kQuadraticRounding * (size + kSize * shift);
}

}  // namespace cognate::synthesis
