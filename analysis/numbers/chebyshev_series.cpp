#include "analysis/numbers/chebyshev_series.hpp"

#include <algorithm>
#include <limits>

namespace cognate::cam {
namespace {

constexpr std::size_t kSize = kChebyshevSize;
using Matrix = std::array<std::array<double, kSize>, kSize>;

/// cos(mπ/24).
constexpr double cosine(std::size_t m) {
  constexpr double kQuarter[] = {1,
                                 0.99144486137381041114,
                                 0.96592582628906828675,
                                 0.92387953251128675613,
                                 0.86602540378443864676,
                                 0.79335334029123516458,
                                 0.70710678118654752440,
                                 0.60876142900872063942,
                                 0.50000000000000000000,
                                 0.38268343236508977173,
                                 0.25881904510252076235,
                                 0.13052619222005159155,
                                 0};
  m %= 48;
  if (m > 24) m = 48 - m;
  return m > 12 ? -kQuarter[24 - m] : kQuarter[m];
}

/// Row j: what the value at node j gives to each coefficient.
constexpr Matrix interpolation() {
  Matrix matrix{};
  for (std::size_t j = 0; j < kSize; ++j) {
    for (std::size_t k = 0; k < kSize; ++k) {
      const double node_share = j % kChebyshevDegree == 0 ? 0.5 : 1;
      const double order_share = k % kChebyshevDegree == 0 ? 0.5 : 1;
      matrix[j][k] = node_share * order_share * (k % 2 ? -1 : 1) * cosine(j * k) / 12;
    }
  }
  return matrix;
}

/// Row k: the series of T_k((u - 1)/2), by T_{k+1}(t) = 2t·T_k(t) - T_{k-1}(t) with
/// 2t = u - 1, u·T_0 = T_1 and u·T_j = (T_{j+1} + T_{j-1})/2. All entries are exact.
constexpr Matrix left_restriction() {
  Matrix matrix{};
  matrix[0][0] = 1;
  matrix[1][0] = -0.5;
  matrix[1][1] = 0.5;
  for (std::size_t k = 1; k + 1 < kSize; ++k) {
    for (std::size_t j = 0; j <= k; ++j) {
      const double share = matrix[k][j];
      matrix[k + 1][j] -= share + matrix[k - 1][j];
      matrix[k + 1][j + 1] += j == 0 ? share : share / 2;
      if (j > 0) matrix[k + 1][j - 1] += share / 2;
    }
  }
  return matrix;
}

constexpr Matrix kInterpolation = interpolation();
constexpr Matrix kLeft = left_restriction();

}  // namespace

double chebyshev_node(std::size_t j) {
  return -cosine(j);
}

ChebyshevSeries interpolant(const ChebyshevSamples& values) {
  ChebyshevSeries series;
  series.size = kSize;
  for (std::size_t j = 0; j < kSize; ++j) {
    for (std::size_t k = 0; k < kSize; ++k) series[k] += values[j] * kInterpolation[j][k];
  }
  return series;
}

void drop_last(ChebyshevSeries& series, double negligible) {
  while (series.size > 1 && std::abs(series[series.size - 1]) <= negligible) --series.size;
}

ChebyshevHalves halves(const ChebyshevSeries& series, double negligible) {
  // T_k(-t) = ±T_k(t): what even and odd orders give is the same on both sides but for signs.
  std::array<double, kSize> of[2]{};
  for (std::size_t k = 0; k < series.size; ++k) {
    for (std::size_t j = 0; j <= k; ++j) of[k % 2][j] += series[k] * kLeft[k][j];
  }
  ChebyshevHalves both;
  both.left.size = both.right.size = series.size;
  for (std::size_t j = 0; j < series.size; ++j) {
    both.left[j] = of[0][j] + of[1][j];
    both.right[j] = of[j % 2][j] - of[1 - j % 2][j];
  }
  drop_last(both.left, negligible);
  drop_last(both.right, negligible);
  return both;
}

ValueAndSlope value_and_slope(const ChebyshevSeries& series, double t) {
  double value = 0, value_after = 0, slope = 0, slope_after = 0;
  for (std::size_t k = series.size - 1; k > 0; --k) {
    const double next_slope = 2 * (value + t * slope) - slope_after;
    const double next = series[k] + 2 * t * value - value_after;
    slope_after = slope;
    slope = next_slope;
    value_after = value;
    value = next;
  }
  return {series[0] + t * value - value_after, value + t * slope - slope_after};
}

ChebyshevSeries derivative(const ChebyshevSeries& series) {
  ChebyshevSeries slope;
  slope.size = std::max<std::size_t>(series.size - 1, 1);
  double after[2] = {0, 0};  // the coefficients after the next and after that
  for (std::size_t k = series.size - 1; k > 0; --k) {
    slope[k - 1] = after[1] + 2 * static_cast<double>(k) * series[k];
    after[1] = after[0];
    after[0] = slope[k - 1];
  }
  slope[0] /= 2;
  return slope;
}

double bracketed_zero(const ChebyshevSeries& series, double a, double b, bool rises) {
  constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
  constexpr int kSteps = 60;  // most are three or four; halving alone takes 53
  const double rounding = kEpsilon * (std::abs(series[0]) + variation_bound(series));
  double t = a + (b - a) / 2, last_step = b - a;
  for (int i = 0; i < kSteps && b - a > 2 * kEpsilon; ++i) {
    const auto [value, slope] = value_and_slope(series, t);
    (is_positive(value) == rises ? b : a) = t;
    double next = std::clamp(t - value / slope, a, b);  // the zero may be at an end
    if (std::abs(value) <= rounding) return std::isnan(next) ? t : next;
    const double step = std::abs(next - t);
    if (!(step > 0 && 2 * step <= last_step)) next = a + (b - a) / 2;
    last_step = std::abs(next - t);
    t = next;
  }
  return t;
}

}  // namespace cognate::cam
