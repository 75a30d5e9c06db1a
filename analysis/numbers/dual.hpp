/// @file A number with its derivative by the drive coordinate.
#pragma once

#include <cmath>

namespace cognate {

/// value + rate·dq. The root of a number below zero is zero: a dyad that is at its limit but for
/// rounding stays there, and what depends on it is still found.
struct Dual {
  double value = 0;
  double rate = 0;

  Dual() = default;
  explicit Dual(double constant) : value(constant) {}
  Dual(double v, double r) : value(v), rate(r) {}

  friend Dual operator+(const Dual& a, const Dual& b) {
    return {a.value + b.value, a.rate + b.rate};
  }
  friend Dual operator-(const Dual& a, const Dual& b) {
    return {a.value - b.value, a.rate - b.rate};
  }
  friend Dual operator-(const Dual& a) { return {-a.value, -a.rate}; }
  friend Dual operator*(const Dual& a, const Dual& b) {
    return {a.value * b.value, a.rate * b.value + a.value * b.rate};
  }
  friend Dual operator/(const Dual& a, const Dual& b) {
    const double quotient = a.value / b.value;
    return {quotient, (a.rate - quotient * b.rate) / b.value};
  }
  friend Dual sqrt(const Dual& a) {
    if (!(a.value > 0)) return Dual(a.value * 0);
    const double root = std::sqrt(a.value);
    return {root, a.rate / (2 * root)};
  }
};

}  // namespace cognate
