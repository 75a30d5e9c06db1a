/// @file The least and greatest angle between diagonal and coupler over boxes of turning four-bars,
/// one box in each lane; in sums without cancellation, so that they hold up to change points.
/// Include in kernels alone. For the coordinates see coupler_models.hpp.
#pragma once

#include "synthesis/lanes/taylor_model.hpp"

namespace cognate::synthesis::COGNATE_ISA {

/// An angle over a box: half its width, sine and cosine of half its middle and of half that width.
struct HalfAngles {
  Real half, sine, cosine, half_sine, half_cosine;
};

struct LanesBox {
  Real k, half_k;
  Real side;      ///< m = side·(2k − 1)
  Real assembly;  ///< ±1
  HalfAngles first, second, phase;
};

struct LanesRange {
  Real low, high, middle;

  Real width() const { return high - low; }
};

/// 1 − cos and 1 + cos of an angle over a box.
struct Versines {
  LanesRange versine, reach;
};

inline Versines versines_of(const HalfAngles& angle) {
  constexpr double kSlack = 2e-15;
  const Real a = angle.sine * angle.half_cosine, b = angle.cosine * angle.half_sine;
  const Real c = angle.cosine * angle.half_cosine, d = angle.sine * angle.half_sine;
  const auto range = [&](const Real& first, const Real& last, const Real& other_first,
                         const Real& other_last, const Real& middle) {
    const Real one = magnitude(first), two = magnitude(last);
    const Mask known = angle.half < Real(3.0);
    const Real least = larger(smaller(one, two) - Real(kSlack), Real(0.0));
    const Real greatest = smaller(larger(one, two) + Real(kSlack), Real(1.0));
    LanesRange r;
    r.low = choose(known && (first * last > Real(0.0)), Real(2.0) * least * least, Real(0.0));
    r.high = choose(known && (other_first * other_last > Real(0.0)),
                    Real(2.0) * greatest * greatest, Real(2.0));
    r.middle = Real(2.0) * middle * middle;
    return r;
  };
  return {range(a - b, a + b, c + d, c - d, angle.sine),
          range(c + d, c - d, a - b, a + b, angle.cosine)};
}

/// tan(β/2) = n/m over a box.
struct TangentRange {
  LanesRange n, m;

  /// By how much β may differ from that of the middle.
  Real spread() const {
    const auto change = [](const Real& n0, const Real& m0, const Real& n1, const Real& m1) {
      const Real left = n1 * m0, right = n0 * m1;
      return (left - right + Real(kPad) * (left + right)) / (m1 * m0 + n1 * n0);
    };
    const Real up = change(n.middle, m.middle, n.high, m.low);
    const Real down = change(m.middle, n.middle, m.high, n.low);
    // The greater of two is a number where one of them is none: their sum is not.
    return Real(2 + 8 * kPad) * (larger(up, down) + Real(0.0) * (up + down));
  }
};

/// A crank angle over a box.
struct CrankPlace {
  HalfAngles crank;
  Real cosine, sine;
  Versines versines;
  Real square, d;  ///< d² and d at the middle
};

/// The least and greatest values over a box.
struct CouplerRanges {
  Real half_k;
  HalfAngles phase;
  Versines first, second;     ///< of ξ and η
  LanesRange inner, product;  ///< m and κ

  explicit CouplerRanges(const LanesBox& box);
  /// At a crank angle of which half has this sine and cosine where the phase is zero.
  CrankPlace place(const Real& half_sine, const Real& half_cosine) const;
  TangentRange tangent(const Versines& crank) const;
  void share(const CrankPlace& place, Real* doubt) const;
};

inline CouplerRanges::CouplerRanges(const LanesBox& box)
    : half_k(box.half_k),
      phase(box.phase),
      first(versines_of(box.first)),
      second(versines_of(box.second)) {
  const Real zero(0.0), one(1.0), two(2.0);
  const auto product_at = [&](const Real& m) { return Real(0.25) * (one - m) * (one + m); };
  inner.middle = smaller(one, larger(zero, box.side * (two * box.k - one)));
  const Real slack = two * box.half_k + Real(kPad);
  inner.low = larger(zero, inner.middle - slack);
  inner.high = smaller(one, inner.middle + slack);
  product.low = product_at(inner.high) * Real(1 - kPad);
  product.high = product_at(inner.low) * Real(1 + kPad);
  product.middle = box.k * (one - box.k);
}

inline CrankPlace CouplerRanges::place(const Real& half_sine, const Real& half_cosine) const {
  CrankPlace p;
  p.crank = phase;
  p.crank.sine = half_sine * phase.cosine + half_cosine * phase.sine;
  p.crank.cosine = half_cosine * phase.cosine - half_sine * phase.sine;
  p.cosine = (p.crank.cosine - p.crank.sine) * (p.crank.cosine + p.crank.sine);
  p.sine = Real(2.0) * p.crank.sine * p.crank.cosine;
  p.versines = versines_of(p.crank);
  p.square = inner.middle * inner.middle + Real(2.0) * product.middle * p.versines.versine.middle;
  p.d = root(p.square);
  return p;
}

/// In sums without cancellation: d − m = 2κ(1 − cos)/(d + m) and 1 − d = 2κ(1 + cos)/(1 + d). d
/// grows with m and 1 − cos, d − m falls with m.
inline TangentRange CouplerRanges::tangent(const Versines& crank) const {
  const Real one(1.0), two(2.0);
  const auto diagonal = [&](const Real& inner, const Real& product, const Real& versine) {
    return root(inner * inner + two * product * versine);
  };
  const auto beyond = [&](const Real& inner, const Real& product, const Real& versine) {
    const Real twice = two * product * versine;
    return twice / (root(inner * inner + twice) + inner + Real(1e-200));
  };
  const LanesRange& v = crank.versine;
  const LanesRange beyond_inner = {beyond(inner.high, product.low, v.low),
                                   beyond(inner.low, product.high, v.high),
                                   beyond(inner.middle, product.middle, v.middle)};
  const Real d_low = diagonal(inner.low, product.high, v.low);
  const Real d_high = diagonal(inner.high, product.low, v.high);
  const Real d = diagonal(inner.middle, product.middle, v.middle);
  const auto side = [&](const LanesRange& versine) {  // d ∓ δ
    return LanesRange{beyond_inner.low + inner.low * versine.low,
                      beyond_inner.high + inner.high * versine.high,
                      beyond_inner.middle + inner.middle * versine.middle};
  };
  const auto lacking = [&](const Real& product, const Real& reach, const Real& at,
                           const Real& versine) {  // 1 − s d
    return two * product * reach / (one + at) + at * versine;
  };
  const LanesRange near = side(first.versine), far = side(first.reach);
  const LanesRange& eta = second.versine;
  const LanesRange low_side = {lacking(product.low, crank.reach.low, d_high, eta.low),
                               lacking(product.high, crank.reach.high, d_low, eta.high),
                               lacking(product.middle, crank.reach.middle, d, eta.middle)};
  const auto added = [&](const Real& at, const Real& versine) {
    return one + (one - versine) * at;
  };
  const LanesRange high_side = {added(d_low, eta.high), added(d_high, eta.low),
                                added(d, eta.middle)};
  const auto geometric = [](const LanesRange& a, const LanesRange& b) {
    return LanesRange{root(a.low * b.low) * Real(1 - kPad), root(a.high * b.high) * Real(1 + kPad),
                      root(a.middle * b.middle)};
  };
  return {geometric(near, low_side), geometric(far, high_side)};
}

/// What each side has in the change of β over the box, in sum 1: by how much it changes the factors
/// of n and m.
inline void CouplerRanges::share(const CrankPlace& p, Real* doubt) const {
  const Real two(2.0), one(1.0), tiny(1e-30);
  const Versines& v = p.versines;
  const Real beyond = two * product.middle * v.versine.middle / (p.d + inner.middle + tiny);
  const Real by_k = half_k * inner.middle / (product.middle + tiny);
  const Real d_by_phase = product.middle * Real(0.5) * v.versine.width() / (p.d + tiny);
  const Real d_by_k = half_k * inner.middle * v.reach.middle / (p.d + tiny);
  const Real s = one - second.versine.middle;
  for (int i = 0; i < 4; ++i) doubt[i] = Real(0.0);
  const auto add = [&](const LanesRange& versine) {  // d ∓ δ
    const Real k = beyond * by_k + two * half_k * versine.middle;
    const Real by_first = inner.middle * Real(0.5) * versine.width();
    const Real most = beyond + inner.middle * versine.middle + k + by_first + d_by_phase + tiny;
    doubt[0] = doubt[0] + k / most;
    doubt[1] = doubt[1] + by_first / most;
    doubt[3] = doubt[3] + d_by_phase / most;
  };
  add(first.versine);
  add(first.reach);
  for (const double sign : {-1.0, 1.0}) {  // 1 ∓ s d
    const Real by_second = p.d * Real(0.5) * second.versine.width();
    const Real k = s * d_by_k, by_phase = s * d_by_phase;
    const Real most =
        larger(one + Real(sign) * s * p.d, Real(0.0)) + by_second + k + by_phase + tiny;
    doubt[0] = doubt[0] + k / most;
    doubt[2] = doubt[2] + by_second / most;
    doubt[3] = doubt[3] + by_phase / most;
  }
  const Real inverse = one / (doubt[0] + doubt[1] + doubt[2] + doubt[3] + tiny);
  for (int i = 0; i < 4; ++i) doubt[i] = doubt[i] * inverse;
}

}  // namespace cognate::synthesis::COGNATE_ISA
