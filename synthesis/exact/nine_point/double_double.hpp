/// @file Real numbers of about 32 digits, as the sum of two doubles. Only where the compiler does
/// not contract expressions (-ffp-contract=off).
#pragma once

#include "analysis/numbers/compensated.hpp"

namespace cognate::synthesis::nine_point {

/// The sum of two doubles, the second within half a unit in the last place of the first.
struct DoubleDouble {
  TwoParts<double> parts;

  DoubleDouble() = default;
  explicit DoubleDouble(double value) : parts{value, 0} {}
  explicit DoubleDouble(const TwoParts<double>& sum) : parts(two_part_sum(sum.high, sum.low)) {}

  friend DoubleDouble operator-(const DoubleDouble& a) {
    DoubleDouble negative;
    negative.parts = -a.parts;
    return negative;
  }
  friend DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
    return DoubleDouble(two_part_sum(a.parts.high, b.parts.high, a.parts.low + b.parts.low));
  }
  friend DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) { return a + -b; }
  friend DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
    return DoubleDouble(product(a.parts, b.parts));
  }
  /// One Newton step from the quotient of the high parts.
  friend DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
    const DoubleDouble quotient(a.parts.high / b.parts.high);
    const DoubleDouble rest = a - quotient * b;
    return quotient + DoubleDouble(rest.parts.high / b.parts.high);
  }
  friend bool operator<(const DoubleDouble& a, const DoubleDouble& b) {
    return a.parts.high < b.parts.high ||
           (a.parts.high == b.parts.high && a.parts.low < b.parts.low);
  }
  friend bool operator>(const DoubleDouble& a, const DoubleDouble& b) { return b < a; }
};

}  // namespace cognate::synthesis::nine_point
