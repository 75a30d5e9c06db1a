/// @file Strips: what a quantity can be over a cell of the drive, between two parallel lines.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace cognate {

/// A quantity x of t, −1 ≤ t ≤ 1, of which |x(t) − middle − slope·t| ≤ radius is known. A number
/// type of the mechanisms' kernel: each operation returns a strip that contains its result for all
/// x from its operands, rounding included, and what they have in common through t cancels to first
/// order, so that radii shrink with the square of the cell. A radius that is infinite or not a
/// number says that nothing is known; it stays so in whatever is computed from it. (An affine form
/// with one symbol: Stolfi and de Figueiredo, Self-Validated Numerical Methods, 1997.)
struct Strip {
  double middle = 0;
  double slope = 0;
  double radius = 0;

  Strip() = default;
  Strip(double x) : middle(x) {}  // NOLINT: a number is a strip
  Strip(double at_middle, double rise, double half)
      : middle(at_middle), slope(rise), radius(half) {}

  /// No value is less, and none greater.
  double low() const { return middle - spread() - kRounding * magnitude(); }
  double high() const { return middle + spread() + kRounding * magnitude(); }
  /// No value is farther from that in the middle.
  double spread() const { return std::abs(slope) + radius; }
  double magnitude() const { return std::abs(middle) + spread(); }

  /// More than the roundings of the few operations of each function here, as a share of the sum of
  /// the magnitudes of their terms; and more than what can underflow.
  static constexpr double kRounding = 8 * std::numeric_limits<double>::epsilon();
  static constexpr double kTiny = 1e-290;
};

/// A strip with room for the rounding of terms of the size `terms`.
inline Strip rounded(double middle, double slope, double radius, double terms) {
  return {middle, slope, radius + Strip::kRounding * terms + Strip::kTiny};
}

inline Strip operator-(const Strip& a) {
  return {-a.middle, -a.slope, a.radius};
}
inline Strip operator+(const Strip& a, const Strip& b) {
  return rounded(a.middle + b.middle, a.slope + b.slope, a.radius + b.radius,
                 a.magnitude() + b.magnitude());
}
inline Strip operator-(const Strip& a, const Strip& b) {
  return a + -b;
}
/// Of the slopes' product, times t² from 0 to 1, half is added to the middle.
inline Strip operator*(const Strip& a, const Strip& b) {
  const double square = 0.5 * a.slope * b.slope;
  const double radius = a.radius * b.magnitude() + b.radius * a.magnitude() + std::abs(square);
  return rounded(a.middle * b.middle + square, a.middle * b.slope + a.slope * b.middle, radius,
                 a.magnitude() * b.magnitude());
}

/// rate·x + [least, greatest].
inline Strip along_line(const Strip& x, double rate, double least, double greatest) {
  return rounded(rate * x.middle + 0.5 * (least + greatest), rate * x.slope,
                 std::abs(rate) * x.radius + 0.5 * (greatest - least),
                 std::abs(rate) * x.magnitude() + std::abs(least) + std::abs(greatest));
}

/// The line of least deviation between the ends of its range; what is negative counts as zero.
inline Strip sqrt(const Strip& x) {
  const double high = x.high();
  if (!(high < std::numeric_limits<double>::infinity())) {
    return {0, 0, std::numeric_limits<double>::quiet_NaN()};
  }
  if (high <= 0) return {};
  const double low_root = std::sqrt(std::max(x.low(), 0.0)), high_root = std::sqrt(high);
  const double sum = low_root + high_root;
  // √x − x/sum is least at both ends of the range and greatest, sum/4, where √x = sum/2.
  return along_line(x, 1 / sum, low_root * high_root / sum, 0.25 * sum);
}

/// Likewise; unknown where the range holds 0.
inline Strip reciprocal(const Strip& x) {
  if (x.middle < 0) return -reciprocal(-x);
  const double low = x.low(), high = x.high();
  if (!(low > 0 && high < std::numeric_limits<double>::infinity())) {
    return {0, 0, std::numeric_limits<double>::quiet_NaN()};
  }
  // 1/x + x/(low·high) is greatest at both ends and least where x² = low·high.
  const double root = std::sqrt(low) * std::sqrt(high);
  return along_line(x, -1 / low / high, 2 / root, 1 / low + 1 / high);
}
inline Strip operator/(const Strip& a, const Strip& b) {
  return a * reciprocal(b);
}

}  // namespace cognate
