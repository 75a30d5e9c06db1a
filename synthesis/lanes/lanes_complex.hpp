/// @file Complex numbers in lanes. Include in kernels alone.
#pragma once

#include "synthesis/lanes/lane_numbers.hpp"

namespace cognate::synthesis::COGNATE_ISA {

struct LanesComplex {
  Real x, y;
};
inline LanesComplex operator*(const LanesComplex& a, const LanesComplex& b) {
  return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x};
}
inline LanesComplex operator*(const Real& a, const LanesComplex& b) {
  return {a * b.x, a * b.y};
}
inline LanesComplex operator+(const LanesComplex& a, const LanesComplex& b) {
  return {a.x + b.x, a.y + b.y};
}
inline LanesComplex operator-(const LanesComplex& a, const LanesComplex& b) {
  return {a.x - b.x, a.y - b.y};
}
/// |a| or up to 8 % more, without a root.
inline Real about_size(const LanesComplex& a) {
  const Real x = magnitude(a.x), y = magnitude(a.y);
  return larger(x, y) + Real(0.41421357) * smaller(x, y);
}

/// conj(a) b
inline LanesComplex conjugate_product(const LanesComplex& a, const LanesComplex& b) {
  return {a.x * b.x + a.y * b.y, a.x * b.y - a.y * b.x};
}
inline Real dot(const LanesComplex& a, const LanesComplex& b) {
  return a.x * b.x + a.y * b.y;
}
inline Real squared(const LanesComplex& a) {
  return a.x * a.x + a.y * a.y;
}
inline void add_to(LanesComplex& sum, const LanesComplex& part) {
  sum.x = sum.x + part.x;
  sum.y = sum.y + part.y;
}
}  // namespace cognate::synthesis::COGNATE_ISA
