/// @file Sines and cosines of angles counted in half turns, exact at whole quarter turns.
#pragma once

#include <cmath>
#include <type_traits>

namespace cognate::cam {

template <class T>
struct SineCosine {
  T sine{};
  T cosine{};
};

/// π to the precision of T, which may be wider than a double.
template <class T>
T pi_of() {
  return T(3.141592653589793238462643383279502884L);
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

}  // namespace cognate::cam
