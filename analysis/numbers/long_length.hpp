/// @file The length of a vector to twice the precision of its number type.
#pragma once

#include <cmath>

#include "analysis/numbers/vec2.hpp"

namespace cognate {

/// a − b − `difference`, exactly, where `difference` is a − b rounded (Knuth's TwoSum).
template <class T>
constexpr T difference_error(const T& a, const T& b, const T& difference) {
  const T part = a - difference;
  return (a - (difference + part)) + (part - b);
}

/// A length as an unevaluated sum of two numbers, `low` being the rounding error of `high`, and
/// 1/high, which takes part in finding it.
template <class T>
struct LongLength {
  T high{};
  T low{};
  T inverse{};
};

/// |v + v_low|, `v_low` being the rounding error of v. The squares must neither overflow nor
/// underflow; a zero vector has a low part that is no number. √ is corrected by one Newton step,
/// the residual |v|² − high² being summed leg by leg.
template <class T>
LongLength<T> long_length(const Vec2<T>& v, const Vec2<T>& v_low) {
  using std::fma;
  using std::max;
  using std::min;
  using std::sqrt;
  const T xx = v.x * v.x, yy = v.y * v.y;
  const T high = sqrt(xx + yy);
  const T hh = high * high;
  const T tails = T(fma(v.x, v.x, T(-xx))) + T(fma(v.y, v.y, T(-yy))) - T(fma(high, high, T(-hh)));
  const T residual = ((max(xx, yy) - hh) + min(xx, yy)) + (tails + T(2) * dot(v, v_low));
  const T inverse = T(1) / high;
  return {high, T(0.5) * inverse * residual, inverse};
}

}  // namespace cognate
