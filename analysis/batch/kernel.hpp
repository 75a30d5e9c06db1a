/// @file The border between the portable code of batches and the kernels compiled for each
/// instruction set: plain values and pointers only, so that no inline function is compiled with
/// wide instructions and then shared.
#pragma once

#include <cstddef>

#include "analysis/batch/design.hpp"
#include "analysis/batch/quantities.hpp"

namespace cognate::batch {

/// Consecutive rows of a crank table on one side: cos θ ≥ 0 for side +1, < 0 for −1.
struct Run {
  std::size_t begin = 0, end = 0;
  int side = 1;
};

/// Entries of a table that may be read beyond its end, so that a pack need not be cut short.
inline constexpr std::size_t kPadding = 16;

/// One design over some runs of a table, none of them shorter than the kernel's lanes. Columns
/// have the order of the table and are null where they are not requested.
template <class Real>
struct OneDesignTask {
  const Design<double>* design;
  Vec2d point;  ///< the coupler point (u, v)
  const Run* runs;
  std::size_t run_count;
  const Real *sin, *versine;
  Real* columns[kColumns];
};

/// Designs [first, last) of `designs`, at least as many as the kernel's lanes, at all rows of a
/// table. Of the columns, value (point, row, design) is at (point·rows + row)·designs + design.
template <class Real>
struct ManyDesignsTask {
  const Real *pivot_a_x, *pivot_a_y, *pivot_d_x, *pivot_d_y;
  const Real *crank, *coupler, *rocker, *assembly;
  const Real *point_u, *point_v;  ///< value (point, design) at point·designs + design
  std::size_t designs, points, first, last;
  const Real *sin, *versine;
  const std::size_t* order;  ///< the row that each entry of the table stands for
  const Run* runs;
  std::size_t run_count, rows;
  Real* columns[kColumns];
};

/// The kernels of one instruction set; `instance` is that of quantities.hpp.
template <class Real>
struct Kernels {
  std::size_t lanes;
  void (*one_design)(std::size_t instance, const OneDesignTask<Real>& task);
  void (*many_designs)(std::size_t instance, const ManyDesignsTask<Real>& task);
};

// One pair for each instruction set.
#define COGNATE_DECLARE_KERNELS(name)         \
  namespace name {                            \
  void get_kernels(Kernels<double>& kernels); \
  void get_kernels(Kernels<float>& kernels);  \
  }
COGNATE_DECLARE_KERNELS(scalar)
COGNATE_DECLARE_KERNELS(sse2)
COGNATE_DECLARE_KERNELS(avx2)
COGNATE_DECLARE_KERNELS(avx512)
#undef COGNATE_DECLARE_KERNELS

}  // namespace cognate::batch
