/// @file The roots and reciprocals of the batch kernels, for their test.
#pragma once

#include <cstddef>

namespace cognate {

/// root[i] = √x[i], inverse[i] = 1/x[i], inverse_root[i] = 1/√x[i]; `count` is a multiple of 16.
template <class Real>
struct RootsTask {
  const Real* x;
  Real *root, *inverse, *inverse_root;
  std::size_t count;
};

#define COGNATE_DECLARE_ROOTS(isa)                \
  namespace batch::isa {                          \
  void find_roots(const RootsTask<double>& task); \
  void find_roots(const RootsTask<float>& task);  \
  }
COGNATE_DECLARE_ROOTS(scalar)
COGNATE_DECLARE_ROOTS(sse2)
COGNATE_DECLARE_ROOTS(avx2)
COGNATE_DECLARE_ROOTS(avx512)
#undef COGNATE_DECLARE_ROOTS

}  // namespace cognate
