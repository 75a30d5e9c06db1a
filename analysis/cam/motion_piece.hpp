/// @file A smooth piece of a follower's motion.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace cognate::cam {

template <class T>
struct SineCosine {
  T sine{};
  T cosine{};
};

/// π to the precision of T, which may be far wider than a double, or carry derivatives: the sum of
/// four doubles that hold π's first 212 bits.
template <class T>
T pi_of() {
  return T(0x1.921fb54442d18p+1) +
         (T(0x1.1a62633145c07p-53) + (T(-0x1.f1976b7ed8fbcp-109) + T(0x1.4cf98e804177dp-163)));
}

/// sin(π x) and cos(π x). x is taken to the nearest quarter turn first, which loses nothing, so
/// that sin(π) is 0 and not 1.2e-16. For every number type with comparisons, +, − and ·, whose sin
/// and cos are found by argument-dependent lookup.
template <class T>
SineCosine<T> sine_cosine_of_half_turns(const T& x) {
  using std::cos;
  using std::sin;
  T rest = x;
  int quarter = 0;
  for (; rest > T(0.25); rest = rest - T(0.5)) quarter = (quarter + 1) & 3;
  for (; rest < T(-0.25); rest = rest + T(0.5)) quarter = (quarter + 3) & 3;
  const T angle = pi_of<T>() * rest;
  const T s = sin(angle), c = cos(angle);
  switch (quarter) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

/// Displacement of a follower and its derivatives by the cam angle in radians: lengths for a
/// translating follower, radians for an oscillating one.
template <class T>
struct FollowerMotion {
  T displacement{};
  T velocity{};
  T acceleration{};
  T jerk{};
};

/// amplitude · sin(π (rate·t + phase)).
template <class T>
struct Sinusoid {
  T amplitude{};
  T rate{};
  T phase{};
};

/// Displacement over [begin, begin + span] of the cam angle, with t = (δ − begin) / span in [0, 1]
/// and x = 2t − 1:
///
///   s = offset + scale · (Σ polynomial[k] xᵏ + Σ sinusoids[i]).
///
/// Every motion law is made of such pieces. The laws of unit rise have coefficients without
/// rounding errors, and powers of ±1 and sines of whole quarter turns have none either: with the
/// start as offset and the rise as scale the ends of a segment are exact to the last digit.
template <class T>
struct MotionPiece {
  static constexpr std::size_t kMostTerms = 16;

  T begin{};
  T span{};
  T offset{};
  T scale = T(1);
  std::array<T, kMostTerms> polynomial{};
  std::array<Sinusoid<T>, 2> sinusoids{};
  int terms = 0;  ///< of the polynomial
  int sinusoid_count = 0;
  int segment = 0;  ///< of the programme it belongs to
};

/// The motion at t in [0, 1] of `piece`.
template <class T>
FollowerMotion<T> motion_at(const MotionPiece<T>& piece, const T& t) {
  const T x = T(2) * t - T(1);
  T s(0), v(0), a(0), j(0);
  for (int k = piece.terms - 1; k >= 0; --k) {  // Horner's scheme for all derivatives at once
    j = j * x + T(3) * a;
    a = a * x + T(2) * v;
    v = v * x + s;
    s = s * x + piece.polynomial[static_cast<std::size_t>(k)];
  }
  v = T(2) * v;
  a = T(4) * a;
  j = T(8) * j;
  for (int i = 0; i < piece.sinusoid_count; ++i) {
    const auto& wave = piece.sinusoids[static_cast<std::size_t>(i)];
    const auto [sine, cosine] = sine_cosine_of_half_turns(wave.rate * t + wave.phase);
    const T w = pi_of<T>() * wave.rate;
    s = s + wave.amplitude * sine;
    v = v + wave.amplitude * w * cosine;
    a = a - wave.amplitude * w * w * sine;
    j = j - wave.amplitude * w * w * w * cosine;
  }
  const T per_angle = T(1) / piece.span;
  const T first = piece.scale * per_angle, second = first * per_angle, third = second * per_angle;
  return {piece.offset + piece.scale * s, first * v, second * a, third * j};
}

}  // namespace cognate::cam
