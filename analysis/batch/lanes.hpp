// Numbers of several lanes, for the instruction set that COGNATE_ISA (a namespace) and
// COGNATE_ARCH (xsimd's architecture; undefined for plain scalars) name. Include in kernel.cpp
// alone: everything that holds wide instructions is in a namespace of its own, or a template on a
// type from there.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#ifdef COGNATE_ARCH
#include <xsimd/xsimd.hpp>
#endif

namespace cognate::batch::COGNATE_ISA {

#ifdef COGNATE_ARCH

template <class Real>
using Pack = xsimd::batch<Real, COGNATE_ARCH>;
template <class Real>
using Register = typename Pack<Real>::register_type;

template <class Real>
inline constexpr std::size_t kPackSize = Pack<Real>::size;

template <class Real>
Pack<Real> load_pack(const Real* from) {
  return Pack<Real>::load_unaligned(from);
}
template <class Real>
void store_pack(const Pack<Real>& pack, Real* to) {
  pack.store_unaligned(to);
}
/// `x`, but `other` where `test` is zero.
template <class Real>
Pack<Real> replace_zero(const Pack<Real>& x, const Pack<Real>& test, const Pack<Real>& other) {
  return xsimd::select(test == Pack<Real>(Real(0)), other, x);
}

/// The greatest power of two not above `x`: infinity has the bits of the exponent, and no others.
template <class Real>
Pack<Real> power_of_two_below(const Pack<Real>& x) {
  return x & Pack<Real>(std::numeric_limits<Real>::infinity());
}

/// 1/x for a power of two, whose exponents add up to twice that of 1.
inline Pack<double> inverse_of_power(const Pack<double>& x) {
  using Bits = xsimd::batch<std::int64_t, COGNATE_ARCH>;
  return xsimd::bitwise_cast<Pack<double>>(Bits(0x7fe0000000000000) - xsimd::bitwise_cast<Bits>(x));
}
inline Pack<float> inverse_of_power(const Pack<float>& x) {
  using Bits = xsimd::batch<std::int32_t, COGNATE_ARCH>;
  return xsimd::bitwise_cast<Pack<float>>(Bits(0x7f000000) - xsimd::bitwise_cast<Bits>(x));
}

#if defined(__AVX512F__)
// a·b + c and c − a·b, rounded once.
inline Pack<double> fused(const Pack<double>& a, const Pack<double>& b, const Pack<double>& c) {
  return _mm512_fmadd_pd(a, b, c);
}
inline Pack<float> fused(const Pack<float>& a, const Pack<float>& b, const Pack<float>& c) {
  return _mm512_fmadd_ps(a, b, c);
}
inline Pack<double> fused_from(const Pack<double>& c, const Pack<double>& a,
                               const Pack<double>& b) {
  return _mm512_fnmadd_pd(a, b, c);
}
inline Pack<float> fused_from(const Pack<float>& c, const Pack<float>& a, const Pack<float>& b) {
  return _mm512_fnmadd_ps(a, b, c);
}
#elif defined(__FMA__)
inline Pack<double> fused(const Pack<double>& a, const Pack<double>& b, const Pack<double>& c) {
  return _mm256_fmadd_pd(a, b, c);
}
inline Pack<float> fused(const Pack<float>& a, const Pack<float>& b, const Pack<float>& c) {
  return _mm256_fmadd_ps(a, b, c);
}
#endif

#if !defined(__FMA__) && !defined(__AVX512F__)
/// a·b + c, rounded once if a·b + c is small to a·b: by Dekker's product of halves, which are split
/// off by Veltkamp's multiplication.
template <class Real>
Pack<Real> fused(const Pack<Real>& a, const Pack<Real>& b, const Pack<Real>& c) {
  const Pack<Real> splitter(std::numeric_limits<Real>::digits > 28 ? Real(0x1p27 + 1)
                                                                   : Real(0x1p12 + 1));
  const Pack<Real> product = a * b;
  const Pack<Real> a_wide = splitter * a, b_wide = splitter * b;
  const Pack<Real> a_high = a_wide - (a_wide - a), b_high = b_wide - (b_wide - b);
  const Pack<Real> a_low = a - a_high, b_low = b - b_high;
  const Pack<Real> error =
      ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low;
  return (product + c) + error;
}
#endif

#else

template <class Real>
using Pack = Real;
template <class Real>
using Register = Real;

template <class Real>
inline constexpr std::size_t kPackSize = 1;

template <class Real>
Real load_pack(const Real* from) {
  return *from;
}
template <class Real>
void store_pack(Real value, Real* to) {
  *to = value;
}
template <class Real>
Real replace_zero(Real x, Real test, Real other) {
  return test == Real(0) ? other : x;
}
template <class Real>
Real power_of_two_below(Real x) {
  return std::ldexp(Real(1), std::ilogb(x));
}
template <class Real>
Real inverse_of_power(Real x) {
  return 1 / x;
}
template <class Real>
Real fused(Real a, Real b, Real c) {
  return std::fma(a, b, c);
}

#endif

/// A pack as a number type of this namespace, for the templates of the geometry.
template <class Real>
struct Lanes {
  static constexpr std::size_t kSize = kPackSize<Real>;

  Register<Real> pack;

  Lanes() = default;
  /// The same value in all lanes.
  explicit Lanes(double value) : pack(Pack<Real>(static_cast<Real>(value))) {}

  static Lanes of(const Pack<Real>& pack) {
    Lanes lanes;
    lanes.pack = pack;
    return lanes;
  }

  static Lanes load(const Real* from) { return of(load_pack(from)); }
  void store(Real* to) const { store_pack<Real>(pack, to); }

  friend Lanes operator+(const Lanes& a, const Lanes& b) { return of(a.pack + b.pack); }
  friend Lanes operator-(const Lanes& a, const Lanes& b) { return of(a.pack - b.pack); }
  friend Lanes operator-(const Lanes& a) { return of(-a.pack); }
  friend Lanes operator*(const Lanes& a, const Lanes& b) { return of(a.pack * b.pack); }
  friend Lanes operator/(const Lanes& a, const Lanes& b) { return of(a.pack / b.pack); }
  friend Lanes abs(const Lanes& a) {
    using std::abs;
    return of(abs(Pack<Real>(a.pack)));
  }
  friend Lanes sqrt(const Lanes& a) {
    using std::sqrt;
    return of(sqrt(Pack<Real>(a.pack)));
  }
  friend Lanes max(const Lanes& a, const Lanes& b) {
    using std::max;
    return of(max(Pack<Real>(a.pack), Pack<Real>(b.pack)));
  }
  friend Lanes min(const Lanes& a, const Lanes& b) {
    using std::min;
    return of(min(Pack<Real>(a.pack), Pack<Real>(b.pack)));
  }

  /// `x`, but `other` where `test` is zero.
  friend Lanes replace_zero(const Lanes& x, const Lanes& test, const Lanes& other) {
    return of(batch::COGNATE_ISA::replace_zero<Real>(Pack<Real>(x.pack), Pack<Real>(test.pack),
                                                     Pack<Real>(other.pack)));
  }

  // What scaling and the length of the frame need, see design.hpp.
  friend Lanes power_of_two_below(const Lanes& x) {
    return of(batch::COGNATE_ISA::power_of_two_below<Real>(Pack<Real>(x.pack)));
  }
  friend Lanes inverse_of_power(const Lanes& x) {
    return of(batch::COGNATE_ISA::inverse_of_power(Pack<Real>(x.pack)));
  }
  friend Lanes fma(const Lanes& a, const Lanes& b, const Lanes& c) {
    return of(fused(Pack<Real>(a.pack), Pack<Real>(b.pack), Pack<Real>(c.pack)));
  }
};

}  // namespace cognate::batch::COGNATE_ISA
