/// @file Sums and products rounded as if they were computed with twice the precision.
///
/// For every number type with + − ·; the error of a product needs a fused multiply-add and is taken
/// to be zero where the type has none.
#pragma once

#include <cmath>

namespace cognate {

/// a + b + c + d, rounded as if summed with twice the precision (Knuth's TwoSum, cascaded).
template <class T>
constexpr T compensated_sum(const T& a, const T& b, const T& c, const T& d, const T& low = T(0)) {
  T sum = a;
  T error = low;
  for (const T* next : {&b, &c, &d}) {
    const T total = sum + *next;
    const T part = total - sum;
    error = error + ((sum - (total - part)) + (*next - part));
    sum = total;
  }
  return sum + error;
}

/// A number as the sum of two, |low| within a rounding or two of high.
template <class T>
struct TwoParts {
  T high{};
  T low{};
};

template <class T>
constexpr TwoParts<T> operator-(const TwoParts<T>& a) {
  return {-a.high, -a.low};
}

/// a + b + low, with the rounding error of a + b in the low part (Knuth, TwoSum).
template <class T>
constexpr TwoParts<T> two_part_sum(const T& a, const T& b, const T& low = T(0)) {
  const T sum = a + b;
  const T part = sum - a;
  return {sum, ((a - (sum - part)) + (b - part)) + low};
}

/// a·b, with the rounding error of the product of the high parts in the low part.
template <class T>
constexpr TwoParts<T> product(const TwoParts<T>& a, const TwoParts<T>& b) {
  using std::fma;
  const T high = a.high * b.high;
  T low = a.high * b.low + a.low * b.high;
  if constexpr (requires { T(fma(a.high, b.high, high)); }) {
    low = low + T(fma(a.high, b.high, T(-high)));
  }
  return {high, low};
}

/// a + b, rounded once or nearly so.
template <class T>
constexpr T rounded_sum(const TwoParts<T>& a, const TwoParts<T>& b) {
  const TwoParts<T> sum = two_part_sum(a.high, b.high, T(a.low + b.low));
  return sum.high + sum.low;
}

}  // namespace cognate
