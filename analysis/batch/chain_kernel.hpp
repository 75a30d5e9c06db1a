/// @file The border between the portable code of batches of chains and the kernels compiled for
/// each instruction set: plain values and pointers only.
#pragma once

#include <cstddef>

#include "analysis/mechanism/mechanism.hpp"

namespace cognate::batch {

/// What is written of one point, body or dyad; null where it is not requested.
struct ChainOutput {
  enum class Of { point, body, dyad } of = Of::point;
  int index = 0;  ///< of the body or dyad
  Vec2d at{};     ///< of a point, in the body's axes
  double*
      first[4]{};  ///< x and its derivatives; or the direction's cosine, then turns; or the sine
  double* second[4]{};  ///< y and its derivatives; or the direction's sine; or the cosine
};

/// Rows [begin, end) of a table of drives, no fewer than the kernel's lanes.
struct ChainTask {
  const Drive<double>* drive;
  const Dyad<double>* dyads;
  const double* sides;
  std::size_t dyad_count;
  const double *cos, *sin, *displacement;
  std::size_t begin, end;
  const ChainOutput* outputs;
  std::size_t output_count;
};

struct ChainKernels {
  std::size_t lanes;
  void (*by_order[4])(const ChainTask& task);  ///< derivatives up to 0…3
};

#define COGNATE_DECLARE_CHAIN_KERNELS(name) \
  namespace name {                          \
  ChainKernels chain_kernels();             \
  }
COGNATE_DECLARE_CHAIN_KERNELS(scalar)
COGNATE_DECLARE_CHAIN_KERNELS(sse2)
COGNATE_DECLARE_CHAIN_KERNELS(avx2)
COGNATE_DECLARE_CHAIN_KERNELS(avx512)
#undef COGNATE_DECLARE_CHAIN_KERNELS

}  // namespace cognate::batch
