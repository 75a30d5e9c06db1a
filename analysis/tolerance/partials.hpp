/// @file A number with its derivatives by a few variables.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "analysis/numbers/compensated.hpp"

namespace cognate {

/// value + Σ by[i]·dxᵢ over T: double, an interval, a number of extended precision. The root of a
/// number that is not positive has no derivative: it is what T makes of 1/0.
template <class T, std::size_t Count>
struct Partials {
  T value{};
  std::array<T, Count> by{};

  Partials() = default;
  explicit Partials(double constant) : value(constant) {
    for (T& one : by) one = T(0);
  }
  Partials(const T& v, const std::array<T, Count>& derivatives) : value(v), by(derivatives) {}

  friend Partials operator+(const Partials& a, const Partials& b) {
    return zipped(a.value + b.value, a, b, [](const T& x, const T& y) { return T(x + y); });
  }
  friend Partials operator-(const Partials& a, const Partials& b) {
    return zipped(a.value - b.value, a, b, [](const T& x, const T& y) { return T(x - y); });
  }
  friend Partials operator-(const Partials& a) {
    return scaled(-a.value, a, [](const T& x) { return T(-x); });
  }
  friend Partials operator*(const Partials& a, const Partials& b) {
    return zipped(a.value * b.value, a, b,
                  [&](const T& x, const T& y) { return T(x * b.value + a.value * y); });
  }
  friend Partials operator/(const Partials& a, const Partials& b) {
    const T inverse = T(1) / b.value;
    const T quotient = a.value * inverse;
    return zipped(quotient, a, b,
                  [&](const T& x, const T& y) { return T((x - quotient * y) * inverse); });
  }
  friend Partials sqrt(const Partials& a) {
    using std::sqrt;
    const T root = sqrt(a.value);
    const T factor = T(1) / (root + root);
    return scaled(root, a, [&](const T& x) { return T(x * factor); });
  }

 private:
  template <class Combine>
  static Partials zipped(const T& value, const Partials& a, const Partials& b,
                         const Combine& combine) {
    Partials result;
    result.value = value;
    for (std::size_t i = 0; i < Count; ++i) result.by[i] = combine(a.by[i], b.by[i]);
    return result;
  }
  template <class Scale>
  static Partials scaled(const T& value, const Partials& a, const Scale& scale) {
    Partials result;
    result.value = value;
    for (std::size_t i = 0; i < Count; ++i) result.by[i] = scale(a.by[i]);
    return result;
  }
};

/// Without the rounding error of the sum: derivatives need none, and an interval holds it already.
template <class T, std::size_t Count>
TwoParts<Partials<T, Count>> two_part_sum(const Partials<T, Count>& a,
                                          const Partials<T, Count>& b) {
  return {a + b, Partials<T, Count>(0)};
}

}  // namespace cognate
