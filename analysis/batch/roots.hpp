// Square roots and reciprocals of lanes, by the unit for them or by estimates.
//
// On AVX-512 the divider is no wider than on AVX2, and estimates of 14 bits refined by
// multiplication are faster. The last step of each takes its residual by a fused operation: the
// root is within 0.63 units in the last place and the reciprocal within 0.53 (0.50 by the units;
// 1.8 where one division serves two reciprocals), as tests/batch/batch_roots_test.cpp measures.
#pragma once

#include <limits>

#include "analysis/batch/lanes.hpp"

namespace cognate::batch::COGNATE_ISA {

/// √discriminant, 1/d², and 1/√discriminant where requested (infinite for zero).
template <class T>
struct Roots {
  T root, inverse, inverse_root;
};

#ifdef __AVX512F__

inline Pack<double> estimate_reciprocal(const Pack<double>& x) {
  return _mm512_rcp14_pd(x);
}
inline Pack<float> estimate_reciprocal(const Pack<float>& x) {
  return _mm512_rcp14_ps(x);
}
/// Zero for zero.
inline Pack<double> estimate_inverse_root(const Pack<double>& x) {
  return _mm512_maskz_rsqrt14_pd(_mm512_cmp_pd_mask(x, _mm512_setzero_pd(), _CMP_NEQ_UQ), x);
}
inline Pack<float> estimate_inverse_root(const Pack<float>& x) {
  return _mm512_maskz_rsqrt14_ps(_mm512_cmp_ps_mask(x, _mm512_setzero_ps(), _CMP_NEQ_UQ), x);
}

/// Newton steps that double the digits of an estimate, the last one apart.
template <class Real>
inline constexpr int kSteps = std::numeric_limits<Real>::digits > 28 ? 1 : 0;

template <class Real>
Pack<Real> reciprocal(const Pack<Real>& x) {
  const Pack<Real> one(Real(1));
  Pack<Real> y = estimate_reciprocal(x);
  for (int step = 0; step <= kSteps<Real>; ++step) y = fused(y, fused_from(one, x, y), y);
  return y;
}

/// √x, and ½/√x to a little less than full precision (zero for zero).
template <class Real>
struct RootPair {
  Pack<Real> root, half_inverse;
};

template <class Real>
RootPair<Real> root_pair(const Pack<Real>& x) {
  const Pack<Real> half(Real(0.5));
  const Pack<Real> estimate = estimate_inverse_root(x);
  Pack<Real> root = x * estimate, half_inverse = half * estimate;
  for (int step = 0; step < kSteps<Real>; ++step) {
    const Pack<Real> error = fused_from(half, root, half_inverse);
    root = fused(root, error, root);
    half_inverse = fused(half_inverse, error, half_inverse);
  }
  return {fused(fused_from(x, root, root), half_inverse, root), half_inverse};
}

/// 1/√x; infinite for zero.
template <class Real>
Pack<Real> inverse_root(const Pack<Real>& x, const RootPair<Real>& pair) {
  const Pack<Real> estimate = pair.half_inverse + pair.half_inverse;
  const Pack<Real> error = fused_from(Pack<Real>(Real(1)), pair.root, estimate);
  const Pack<Real> inverse = fused(estimate, error, estimate);
  return replace_zero<Real>(inverse, x, Pack<Real>(std::numeric_limits<Real>::infinity()));
}

template <class Real>
Pack<Real> inverse_root(const Pack<Real>& x) {
  return inverse_root<Real>(x, root_pair<Real>(x));
}

template <bool kInverseRoot, class Real>
Roots<Lanes<Real>> roots(const Lanes<Real>& discriminant, const Lanes<Real>& d2) {
  const Pack<Real> x = discriminant.pack;
  const RootPair<Real> pair = root_pair<Real>(x);
  Roots<Lanes<Real>> result;
  result.root.pack = pair.root;
  result.inverse.pack = reciprocal<Real>(d2.pack);
  if constexpr (kInverseRoot) result.inverse_root.pack = inverse_root<Real>(x, pair);
  return result;
}

#else

template <class Real>
Pack<Real> inverse_root(const Pack<Real>& x) {
  using std::sqrt;
  return Pack<Real>(Real(1)) / sqrt(x);
}

/// The two reciprocals come from one division, of 1 by d²·√.
template <bool kInverseRoot, class Real>
Roots<Lanes<Real>> roots(const Lanes<Real>& discriminant, const Lanes<Real>& d2) {
  using T = Lanes<Real>;
  Roots<T> result;
  result.root = sqrt(discriminant);
  if constexpr (!kInverseRoot) {
    result.inverse = T(1) / d2;
  } else {
    // Stands for a root of zero, so that 1/d² is still found; far below any other root.
    const T small(std::numeric_limits<Real>::digits > 28 ? 1e-160 : 1e-20);
    const T infinity(std::numeric_limits<double>::infinity());
    const T divisor = replace_zero(result.root, result.root, small);
    const T both = T(1) / (d2 * divisor);
    result.inverse = both * divisor;
    result.inverse_root = replace_zero(both * d2, result.root, infinity);
  }
  return result;
}

#endif

template <class Real>
Lanes<Real> lane_inverse_root(const Lanes<Real>& x) {
  return Lanes<Real>::of(inverse_root<Real>(Pack<Real>(x.pack)));
}

}  // namespace cognate::batch::COGNATE_ISA
