/// @file What the kernel is measured against: the textbook's form, and the units for roots and
/// divisions alone.
#pragma once

#include <span>

#include "analysis/linkage/four_bar.hpp"

namespace cognate::bench {

/// The coupler point by the angles of the links: cos and sin of the crank, then atan2 and acos for
/// the coupler, as in Norton, Design of Machinery, section 4.5, by the law of cosines.
template <class Real>
void textbook(const FourBar& linkage, std::span<const Real> angles, std::span<Real> x,
              std::span<Real> y);

/// out[i] = √a[i] + 1/b[i]: as many roots and divisions as positions, independent of each other,
/// and nothing else. `count` is a multiple of 16.
using BoundKernel = void (*)(const void* a, const void* b, void* out, std::size_t count);

#define COGNATE_DECLARE_BOUND(isa)                                               \
  namespace isa {                                                                \
  void bound_double(const void* a, const void* b, void* out, std::size_t count); \
  void bound_float(const void* a, const void* b, void* out, std::size_t count);  \
  }
COGNATE_DECLARE_BOUND(scalar)
COGNATE_DECLARE_BOUND(sse2)
COGNATE_DECLARE_BOUND(avx2)
COGNATE_DECLARE_BOUND(avx512)
#undef COGNATE_DECLARE_BOUND

}  // namespace cognate::bench
