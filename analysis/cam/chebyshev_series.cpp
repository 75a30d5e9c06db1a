#include "analysis/cam/chebyshev_series.hpp"

#include <algorithm>

namespace cognate::cam {
namespace {

constexpr std::size_t kSize = kChebyshevSize;
using Matrix = std::array<std::array<double, kSize>, kSize>;

/// cos(mπ/16).
constexpr double cosine(std::size_t m) {
  constexpr double kQuarter[] = {1,
                                 0.98078528040323044913,
                                 0.92387953251128675613,
                                 0.83146961230254523708,
                                 0.70710678118654752440,
                                 0.55557023301960222474,
                                 0.38268343236508977173,
                                 0.19509032201612826785,
                                 0};
  m %= 32;
  if (m > 16) m = 32 - m;
  return m > 8 ? -kQuarter[16 - m] : kQuarter[m];
}

/// Row j: what the value at node j gives to each coefficient.
constexpr Matrix interpolation() {
  Matrix matrix{};
  for (std::size_t j = 0; j < kSize; ++j) {
    for (std::size_t k = 0; k < kSize; ++k) {
      const double node_share = j % kChebyshevDegree == 0 ? 0.5 : 1;
      const double order_share = k % kChebyshevDegree == 0 ? 0.5 : 1;
      matrix[j][k] = node_share * order_share * (k % 2 ? -1 : 1) * cosine(j * k) / 8;
    }
  }
  return matrix;
}

/// Row k: the series of T_k((u + shift)/2), by T_{k+1}(t) = 2t·T_k(t) - T_{k-1}(t) with
/// 2t = u + shift, u·T_0 = T_1 and u·T_j = (T_{j+1} + T_{j-1})/2. All entries are exact.
constexpr Matrix restriction(double shift) {
  Matrix matrix{};
  matrix[0][0] = 1;
  matrix[1][0] = shift / 2;
  matrix[1][1] = 0.5;
  for (std::size_t k = 1; k + 1 < kSize; ++k) {
    for (std::size_t j = 0; j <= k; ++j) {
      const double share = matrix[k][j];
      matrix[k + 1][j] += shift * share - matrix[k - 1][j];
      matrix[k + 1][j + 1] += j == 0 ? share : share / 2;
      if (j > 0) matrix[k + 1][j - 1] += share / 2;
    }
  }
  return matrix;
}

constexpr Matrix kInterpolation = interpolation();
constexpr Matrix kLeft = restriction(-1);
constexpr Matrix kRight = restriction(1);

ChebyshevSeries combine(const Matrix& rows, const std::array<double, kSize>& shares) {
  ChebyshevSeries sum{};
  for (std::size_t i = 0; i < kSize; ++i) {
    for (std::size_t k = 0; k < kSize; ++k) sum[k] += shares[i] * rows[i][k];
  }
  return sum;
}

}  // namespace

double chebyshev_node(std::size_t j) {
  return -cosine(j);
}

ChebyshevSeries interpolant(const ChebyshevSamples& values) {
  return combine(kInterpolation, values);
}

ChebyshevSeries left_half(const ChebyshevSeries& series) {
  return combine(kLeft, series);
}

ChebyshevSeries right_half(const ChebyshevSeries& series) {
  return combine(kRight, series);
}

ValueAndSlope value_and_slope(const ChebyshevSeries& series, double t) {
  double value = 0, value_after = 0, slope = 0, slope_after = 0;
  for (std::size_t k = kSize - 1; k > 0; --k) {
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
  ChebyshevSeries slope{};
  slope[kSize - 2] = 2 * (kSize - 1) * series[kSize - 1];
  for (std::size_t k = kSize - 2; k > 0; --k) {
    slope[k - 1] = slope[k + 1] + 2 * static_cast<double>(k) * series[k];
  }
  slope[0] /= 2;
  return slope;
}

double bracketed_zero(const ChebyshevSeries& series, double a, double b, bool rises) {
  constexpr double kClose = 4e-16;
  constexpr int kSteps = 120;  // most are two or three; halving alone takes 54
  double t = a + (b - a) / 2, last_step = b - a;
  for (int i = 0; i < kSteps && b - a > kClose; ++i) {
    const auto [value, slope] = value_and_slope(series, t);
    (is_positive(value) == rises ? b : a) = t;
    double next = t - value / slope;
    const bool is_slow = 2 * std::abs(next - t) > last_step;
    if (!(a <= next && next <= b) || is_slow) next = a + (b - a) / 2;
    last_step = std::abs(next - t);
    t = next;
    if (last_step <= kClose) break;
  }
  return std::clamp(t, a, b);
}

}  // namespace cognate::cam
