/// @file Problems of the Alt–Burmester family over the complex numbers, and the way from one to
/// another.
#pragma once

#include <complex>
#include <span>
#include <vector>

#include "synthesis/exact/nine_point/nine_point.hpp"
#include "synthesis/exact/nine_point/track_kernel.hpp"

namespace cognate::synthesis::nine_point {

using Number = std::complex<double>;

/// The data of a problem; `d_bar` is the conjugate of `d` in a real one.
struct PathParameters {
  PathClass kind;
  std::vector<Number> d, d_bar;  ///< those of the kind.poses − 1 poses first
  std::vector<Number> t;         ///< rotations of the poses
};

PathParameters parameters_of(const PathSystem& system);

/// Straight lines for displacements. A rotation goes from t₀ to t₁ as a quotient of straight lines,
/// the numerator from t₀ to the geometric mean w of the two and the denominator from 1 to w/t₁:
/// both turn by less than half of the angle between t₀ and t₁, so that neither comes near zero.
ParameterLine parameter_line(const PathParameters& from, const PathParameters& to);

/// The data at one place of such a way, which ends at data of the class `kind`.
PathParameters parameters_at(const ParameterLine& line, double r, const PathClass& kind);

/// Numbers in memory as the kernel has them: kPivots pivots, then a rotation for each point.
using RootNumbers = std::vector<Pair>;

inline Number number(const Pair& pair) {
  return {pair.re, pair.im};
}
inline Pair pair(const Number& number) {
  return {number.real(), number.imag()};
}

/// What does not change when the dyads are swapped nor, for class (1, 8), when a cognate takes the
/// place of a solution: there, the sum of the foci a + b + (bx − ay)/(x − y); else a generic linear
/// combination of a + b and x + y. `size` is what its rounding errors are relative to.
struct Fingerprint {
  Number plain, barred;
  double size = 0;
};

Fingerprint fingerprint(const PathClass& kind, std::span<const Pair> root);

/// Whether two fingerprints are the same within `tolerance` of their size.
bool same(const Fingerprint& a, const Fingerprint& b, double tolerance);

/// Distinct fingerprints, found again by their values.
class FingerprintIndex {
 public:
  /// The index of the one known to be the same, or −1.
  int find(const Fingerprint& print, double tolerance) const;
  /// Adds one under the next index.
  void add(const Fingerprint& print);

 private:
  std::vector<Fingerprint> prints_;
  std::vector<std::pair<double, int>> sorted_;  ///< by the real part
};

/// The next cognate of a solution of class (1, 8): see cognates() in nine_point.hpp.
RootNumbers next_cognate(const PathParameters& data, std::span<const Pair> root);

}  // namespace cognate::synthesis::nine_point
