/// @file The numbers of a kernel, one of each path that is followed at the same time: those of
/// lane_numbers.hpp, or a single double-double number where COGNATE_DOUBLE_DOUBLE is defined.
/// Include in the kernel alone.
#pragma once

#include <algorithm>
#include <cmath>

#ifdef COGNATE_DOUBLE_DOUBLE
#include "synthesis/exact/nine_point/double_double.hpp"
#else
#include "synthesis/lanes/lane_numbers.hpp"
#endif

namespace cognate::synthesis::nine_point::COGNATE_ISA {

#ifdef COGNATE_DOUBLE_DOUBLE

using Real = DoubleDouble;
inline constexpr int kLanes = 1;
inline Real load(const double* from) {
  return Real(*from);
}
inline void store(const Real& value, double* to) {
  *to = value.parts.high;
}
inline void set_lane(Real& value, int, double to) {
  value = Real(to);
}
using Mask = bool;
inline Real choose(bool mask, const Real& yes, const Real& no) {
  return mask ? yes : no;
}
inline Real magnitude(const Real& x) {
  return x < Real(0.0) ? -x : x;
}
inline Real larger(const Real& a, const Real& b) {
  return a < b ? b : a;
}

#else

using synthesis::COGNATE_ISA::choose;
using synthesis::COGNATE_ISA::kLanes;
using synthesis::COGNATE_ISA::larger;
using synthesis::COGNATE_ISA::load;
using synthesis::COGNATE_ISA::magnitude;
using synthesis::COGNATE_ISA::Mask;
using synthesis::COGNATE_ISA::Real;
using synthesis::COGNATE_ISA::set_lane;
using synthesis::COGNATE_ISA::store;

#endif

/// A complex number in each lane.
struct Complex {
  Real re, im;

  friend Complex operator+(const Complex& a, const Complex& b) {
    return {a.re + b.re, a.im + b.im};
  }
  friend Complex operator-(const Complex& a, const Complex& b) {
    return {a.re - b.re, a.im - b.im};
  }
  friend Complex operator-(const Complex& a) { return {-a.re, -a.im}; }
  friend Complex operator*(const Complex& a, const Complex& b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
  }
  friend Complex operator*(const Real& k, const Complex& a) { return {k * a.re, k * a.im}; }
};

inline Complex conjugate(const Complex& a) {
  return {a.re, -a.im};
}
inline Real squared_norm(const Complex& a) {
  return a.re * a.re + a.im * a.im;
}
/// |re| + |im|: as good as the modulus where sizes are compared, and cheaper.
inline Real size(const Complex& a) {
  return magnitude(a.re) + magnitude(a.im);
}
inline Complex inverse(const Complex& a) {
  return (Real(1.0) / squared_norm(a)) * conjugate(a);
}
inline Complex choose(const Mask& mask, const Complex& yes, const Complex& no) {
  return {choose(mask, yes.re, no.re), choose(mask, yes.im, no.im)};
}
/// a + b·c and a − b·c, in fused operations where there are some.
inline Complex add_product(const Complex& a, const Complex& b, const Complex& c) {
  return {(a.re + b.re * c.re) - b.im * c.im, (a.im + b.re * c.im) + b.im * c.re};
}
inline Complex subtract_product(const Complex& a, const Complex& b, const Complex& c) {
  return {(a.re - b.re * c.re) + b.im * c.im, (a.im - b.re * c.im) - b.im * c.re};
}

}  // namespace cognate::synthesis::nine_point::COGNATE_ISA
