/// @file Balls of complex numbers: arithmetic whose results contain every true result.
#pragma once

#include <cmath>
#include <complex>
#include <limits>

namespace cognate::synthesis {

/// All complex numbers within `radius` of re + i·im, both of type T. Each operation returns a ball
/// that contains its result for every choice of operands from theirs, the rounding of its own
/// middle included, in rounding to nearest: a sum is off by at most u|s|, a product of complex
/// numbers by √5 u|a||b| (Brent, Percival & Zimmermann, Math. Comp. 76, 2007), u the unit roundoff
/// of T. Radii are computed in double and enlarged by more than their own rounding.
template <class T>
struct Ball {
  T re{}, im{};
  double radius = 0;

  Ball() = default;
  Ball(const T& real, const T& imaginary, double r) : re(real), im(imaginary), radius(r) {}
  explicit Ball(const std::complex<double>& z) : re(z.real()), im(z.imag()) {}

  friend Ball operator+(const Ball& a, const Ball& b) { return sum(a, b.re, b.im, b.radius); }
  friend Ball operator-(const Ball& a, const Ball& b) { return sum(a, -b.re, -b.im, b.radius); }
  friend Ball operator*(const Ball& a, const Ball& b) {
    const double size_a = magnitude(a), size_b = magnitude(b);
    const double spread = size_a * b.radius + a.radius * (size_b + b.radius);
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re,
            enlarged(spread + 4 * kRoundoff * size_a * size_b)};
  }

  /// An upper bound of the modulus of the middle.
  friend double magnitude(const Ball& a) {
    const double re = double(a.re), im = double(a.im);
    return enlarged(std::sqrt(re * re + im * im));
  }

  /// The ball that holds 1/z for every z of `a`; infinite where that is not bounded.
  friend Ball inverse(const Ball& a) {
    const T square = a.re * a.re + a.im * a.im;
    const double size = magnitude(a) * (1 - 64 * kDouble) - 2 * kTiny;  // at most |middle|
    const double gap = size - enlarged(a.radius);
    if (!(gap > 0)) return {T(0), T(0), std::numeric_limits<double>::infinity()};
    const double spread = enlarged(a.radius) / (size * gap);
    return {a.re / square, -a.im / square, enlarged(spread + 8 * kRoundoff / size)};
  }

  /// `x`, computed in double from what is not negative, enlarged beyond its rounding.
  static double enlarged(double x) { return x * (1 + 16 * kDouble) + kTiny; }

 private:
  static constexpr double kDouble = std::numeric_limits<double>::epsilon();
  static constexpr double kTiny = 1e-300;  // covers what is lost below the least normal number
  static constexpr double kRoundoff =
      std::numeric_limits<T>::digits > 53 ? 0x1p-112 : 0x1p-53;  // no less than T's

  static Ball sum(const Ball& a, const T& re, const T& im, double radius) {
    Ball result{a.re + re, a.im + im, 0};
    result.radius = enlarged(a.radius + radius + kRoundoff * magnitude(result));
    return result;
  }
};

/// Whether the two have no point in common, beyond doubt.
template <class T>
bool are_apart(const Ball<T>& a, const Ball<T>& b) {
  const Ball<T> gap = a - b;
  const double distance =
      std::sqrt(double(gap.re) * double(gap.re) + double(gap.im) * double(gap.im));
  return distance > Ball<T>::enlarged(gap.radius) * (1 + 1e-12);
}

}  // namespace cognate::synthesis
