/// @file Real numbers in lanes, for kernels that decide lane by lane: packs of doubles for the
/// instruction set that COGNATE_ISA (a namespace) and COGNATE_ARCH (xsimd's architecture; undefined
/// for scalars) name. Include in kernels alone.
#pragma once

#include "analysis/batch/lanes.hpp"

namespace cognate::synthesis::COGNATE_ISA {

using Real = batch::COGNATE_ISA::Pack<double>;
inline constexpr int kLanes = static_cast<int>(batch::COGNATE_ISA::kPackSize<double>);

inline Real load(const double* from) {
  return batch::COGNATE_ISA::load_pack(from);
}
inline void store(const Real& value, double* to) {
  batch::COGNATE_ISA::store_pack<double>(value, to);
}
inline void set_lane(Real& value, int lane, double to) {
  double values[kLanes];
  store(value, values);
  values[lane] = to;
  value = load(values);
}

#ifdef COGNATE_ARCH

using Mask = Real::batch_bool_type;
inline Real choose(const Mask& mask, const Real& yes, const Real& no) {
  return xsimd::select(mask, yes, no);
}
inline Real magnitude(const Real& x) {
  return xsimd::abs(x);
}
inline Real larger(const Real& a, const Real& b) {
  return xsimd::max(a, b);
}
inline Real smaller(const Real& a, const Real& b) {
  return xsimd::min(a, b);
}
inline Real root(const Real& x) {
  return xsimd::sqrt(x);
}
inline bool any(const Mask& mask) {
  return xsimd::any(mask);
}

#else

using Mask = bool;
inline Real choose(bool mask, Real yes, Real no) {
  return mask ? yes : no;
}
inline Real magnitude(Real x) {
  return std::abs(x);
}
inline Real larger(Real a, Real b) {
  return a < b ? b : a;
}
inline Real smaller(Real a, Real b) {
  return b < a ? b : a;
}
inline Real root(Real x) {
  return std::sqrt(x);
}
inline bool any(bool mask) {
  return mask;
}

#endif

}  // namespace cognate::synthesis::COGNATE_ISA
