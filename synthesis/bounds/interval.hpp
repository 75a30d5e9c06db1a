/// @file Intervals of real numbers: arithmetic whose results contain every true result.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/numbers/constants.hpp"

namespace cognate::synthesis {

/// All real numbers from `low` to `high`. Each operation returns an interval that contains its
/// result for every choice of operands from theirs: its ends, rounded to nearest, are moved outward
/// by more than the rounding.
struct Interval {
  double low = 0;
  double high = 0;

  Interval() = default;
  Interval(double point) : low(point), high(point) {}  // NOLINT: a number is an interval
  Interval(double least, double greatest) : low(least), high(greatest) {}

  double middle() const { return 0.5 * (low + high); }
  /// At least the distance of either end from `middle()`.
  double radius() const { return above(std::max(high - middle(), middle() - low)); }
  /// The greatest absolute value.
  double magnitude() const { return std::max(-low, high); }

  /// Bounds of the number that was rounded to `x`.
  static double below(double x) { return x - (kRounding * std::abs(x) + kTiny); }
  static double above(double x) { return x + (kRounding * std::abs(x) + kTiny); }

 private:
  static constexpr double kRounding = std::numeric_limits<double>::epsilon();
  static constexpr double kTiny = 1e-300;
};

inline Interval outward(double low, double high) {
  return {Interval::below(low), Interval::above(high)};
}

inline Interval operator-(const Interval& a) {
  return {-a.high, -a.low};
}
inline Interval operator+(const Interval& a, const Interval& b) {
  return outward(a.low + b.low, a.high + b.high);
}
inline Interval operator-(const Interval& a, const Interval& b) {
  return outward(a.low - b.high, a.high - b.low);
}
/// Of ends: 0·∞ is 0, since an infinite end is the limit of finite ones.
inline double product_of_ends(double x, double y) {
  const double product = x * y;
  return std::isnan(product) && !std::isnan(x) && !std::isnan(y) ? 0 : product;
}
inline Interval operator*(const Interval& a, const Interval& b) {
  const double p = product_of_ends(a.low, b.low), q = product_of_ends(a.low, b.high);
  const double r = product_of_ends(a.high, b.low), s = product_of_ends(a.high, b.high);
  return outward(std::min(std::min(p, q), std::min(r, s)),
                 std::max(std::max(p, q), std::max(r, s)));
}
/// Not numbers where 0 lies within `b`.
inline Interval operator/(const Interval& a, const Interval& b) {
  if (b.high < 0) return -a / -b;
  if (b.low < 0) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    return {kNone, kNone};
  }
  return outward(a.low / (a.low < 0 ? b.low : b.high), a.high / (a.high < 0 ? b.high : b.low));
}

inline Interval square(const Interval& a) {
  if (a.low >= 0) return outward(a.low * a.low, a.high * a.high);
  if (a.high <= 0) return outward(a.high * a.high, a.low * a.low);
  const double greatest = a.magnitude();
  return {0, Interval::above(greatest * greatest)};
}

/// What is negative counts as zero.
inline Interval sqrt(const Interval& a) {
  const Interval root = outward(std::sqrt(std::max(a.low, 0.0)), std::sqrt(std::max(a.high, 0.0)));
  return {std::max(root.low, 0.0), root.high};
}

/// The part of `a` between `low` and `high`, one of its ends where there is none.
inline Interval clamped(const Interval& a, double low, double high) {
  return {std::clamp(a.low, low, high), std::clamp(a.high, low, high)};
}

/// For angles of a few turns at most, whose own rounding counts as well.
inline Interval cos(const Interval& angle) {
  constexpr double pi = kPi, slack = 4e-15;
  if (angle.high - angle.low >= 2 * pi) return {-1, 1};
  const double a = std::cos(angle.low), b = std::cos(angle.high);
  const auto passes = [&](double phase) {  // whether phase + 2πk lies within, in doubt yes
    const double turns = std::ceil((angle.low - slack - phase) / (2 * pi));
    return phase + 2 * pi * turns <= angle.high + slack;
  };
  const double least = passes(pi) ? -1 : std::max(-1.0, std::min(a, b) - slack);
  const double greatest = passes(0) ? 1 : std::min(1.0, std::max(a, b) + slack);
  return {least, greatest};
}

inline Interval sin(const Interval& angle) {
  constexpr double quarter = kRightAngle;
  return cos(Interval{angle.low - quarter, angle.high - quarter});
}

}  // namespace cognate::synthesis
