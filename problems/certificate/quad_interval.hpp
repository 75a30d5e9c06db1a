/// @file Intervals whose ends have 113 bits, for checks that share no arithmetic with a proof.
///
/// Each operation of Quad is rounded to nearest, by a relative 2⁻¹¹³ at most, and no result leaves
/// the range of its exponents; so ends that are moved outward by a relative 2⁻¹¹¹ hold the true
/// result. Boost's sine and cosine err by a few units in the last place; 2⁻¹⁰⁰ is allowed.
#pragma once

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>

namespace cognate::problems {

using Quad = boost::multiprecision::cpp_bin_float_quad;

/// All numbers from `low` to `high`.
struct QuadInterval {
  Quad low = 0;
  Quad high = 0;

  QuadInterval() = default;
  QuadInterval(const Quad& point) : low(point), high(point) {}  // NOLINT: a number is an interval
  QuadInterval(double point) : low(point), high(point) {}       // NOLINT: likewise
  QuadInterval(const Quad& least, const Quad& greatest) : low(least), high(greatest) {}

  Quad middle() const { return (low + high) / 2; }
  Quad magnitude() const { return -low > high ? Quad(-low) : high; }
};

inline QuadInterval moved_outward(const Quad& low, const Quad& high) {
  static const Quad margin = ldexp(Quad(1), -111);
  return {low - margin * abs(low), high + margin * abs(high)};
}

inline QuadInterval operator-(const QuadInterval& a) {
  return {-a.high, -a.low};
}
inline QuadInterval operator+(const QuadInterval& a, const QuadInterval& b) {
  return moved_outward(a.low + b.low, a.high + b.high);
}
inline QuadInterval operator-(const QuadInterval& a, const QuadInterval& b) {
  return moved_outward(a.low - b.high, a.high - b.low);
}
inline QuadInterval operator*(const QuadInterval& a, const QuadInterval& b) {
  if (a.low >= 0) {
    return moved_outward((b.low >= 0 ? a.low : a.high) * b.low,
                         (b.high >= 0 ? a.high : a.low) * b.high);
  }
  if (a.high <= 0) return -(-a * b);
  if (b.low >= 0 || b.high <= 0) return b * a;
  return moved_outward(std::min<Quad>(a.low * b.high, a.high * b.low),
                       std::max<Quad>(a.low * b.low, a.high * b.high));
}
/// `b` is positive.
inline QuadInterval operator/(const QuadInterval& a, const QuadInterval& b) {
  return moved_outward(a.low / (a.low < 0 ? b.low : b.high),
                       a.high / (a.high < 0 ? b.high : b.low));
}
inline QuadInterval& operator+=(QuadInterval& a, const QuadInterval& b) {
  return a = a + b;
}

inline QuadInterval square(const QuadInterval& a) {
  if (a.low >= 0) return moved_outward(a.low * a.low, a.high * a.high);
  if (a.high <= 0) return moved_outward(a.high * a.high, a.low * a.low);
  const Quad most = a.magnitude();
  return {0, moved_outward(0, most * most).high};
}

/// What is negative counts as zero.
inline QuadInterval root(const QuadInterval& a) {
  const auto of = [](const Quad& x) { return x > 0 ? Quad(sqrt(x)) : Quad(0); };
  return moved_outward(of(a.low), of(a.high));
}

/// The part of `a` from `low` to `high`, one of these where there is none.
inline QuadInterval within(const QuadInterval& a, const Quad& low, const Quad& high) {
  const auto clamp = [&](const Quad& x) { return x < low ? low : x > high ? high : x; };
  return {clamp(a.low), clamp(a.high)};
}

/// 2π, to the last place.
const Quad& quad_turn();

/// The cosines of `angle`, given those of its ends.
QuadInterval cosine_between(const QuadInterval& angle, const QuadInterval& at_low,
                            const QuadInterval& at_high);
QuadInterval cosine(const Quad& angle);
QuadInterval sine(const Quad& angle);
QuadInterval cosine(const QuadInterval& angle);
QuadInterval sine(const QuadInterval& angle);

struct QuadComplex {
  QuadInterval re, im;
};

inline QuadComplex operator+(const QuadComplex& a, const QuadComplex& b) {
  return {a.re + b.re, a.im + b.im};
}
inline QuadComplex operator-(const QuadComplex& a, const QuadComplex& b) {
  return {a.re - b.re, a.im - b.im};
}
inline QuadComplex operator*(const QuadComplex& a, const QuadComplex& b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
inline QuadComplex operator*(const QuadInterval& a, const QuadComplex& b) {
  return {a * b.re, a * b.im};
}
inline QuadComplex& operator+=(QuadComplex& a, const QuadComplex& b) {
  return a = a + b;
}
inline QuadComplex conjugate(const QuadComplex& a) {
  return {a.re, -a.im};
}
/// Re(conj(a) b).
inline QuadInterval inner_product(const QuadComplex& a, const QuadComplex& b) {
  return a.re * b.re + a.im * b.im;
}
inline QuadInterval squared_size(const QuadComplex& a) {
  return square(a.re) + square(a.im);
}

}  // namespace cognate::problems
