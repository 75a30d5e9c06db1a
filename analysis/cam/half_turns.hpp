/// @file Sines and cosines of angles counted in half turns, exact at whole quarter turns.
#pragma once

#include <cmath>

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

}  // namespace cognate::cam
