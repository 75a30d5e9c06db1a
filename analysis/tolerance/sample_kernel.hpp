/// @file The border between the portable code of sampling and the kernels compiled for each
/// instruction set: plain values and pointers only.
#pragma once

#include <cstddef>

#include "analysis/mechanism/mechanism.hpp"

namespace cognate::tolerance {

/// Samples of a block, a multiple of every kernel's lanes; the last block's are filled up.
inline constexpr std::size_t kBlockSamples = 64;

/// One response of a block. Its values are columns of `kBlockSamples`, x and y one for each
/// station.
struct BlockOutput {
  enum class Of { angle, displacement, point, transmission, along, direction } of = Of::angle;
  int body = 0;          ///< or the dyad of a transmission angle, or the slider
  int point = 0;         ///< index of a point
  int to = 0;            ///< of a direction: index of the point to which it is
  int guide = 0;         ///< of a displacement: the body with the slide, and the slide in its axes
  Vec2d through, along;  ///< `along` also of how far a point lies in that direction
  double *x = nullptr, *y = nullptr;
};

/// A mechanism over the changes of its dimensions, and what is asked of it.
struct BlockTask {
  const Drive<double>* drive;
  const Dyad<double>* dyads;
  std::size_t dyad_count;
  const Attached<double>* points;
  std::size_t point_count;
  // Number i of the mechanism grows by factor·change for its terms [begin[i], begin[i + 1]).
  const std::size_t* begin;
  const std::size_t* dimension;
  const double* factor;
  const double* changes;  ///< column of `kBlockSamples` for each dimension
  // Of each station.
  const double *cos, *sin, *displacement;
  const double* sides;  ///< dyad_count for each
  std::size_t stations;
  const BlockOutput* outputs;
  std::size_t output_count;
};

/// How far the samples of a block err in one response.
struct ErrorTask {
  const double *x, *y;  ///< columns of `kBlockSamples` for each station
  std::size_t stations, samples;
  bool angular, point;
  const Vec2d* reference;  ///< nominal value at each station; of a point its target
  const Vec2d* normal;     ///< along which a point's distance counts, or null
  const double* offset;    ///< nominal error at each station, of scalars
  const double* weight;    ///< 1, or 0 of samples that are not assembled
  double* extreme;         ///< of each sample: greatest error, is raised
  double *sum, *square;    ///< of each station: of the deviation and of its square, are added to
};

/// The four-bars of a block, as batches take them. Its outputs are the rocker's angle or a point of
/// the coupler each.
struct FourBarTask {
  const BlockTask* mechanism;
  double* own;    ///< columns of `kBlockSamples`: x and y of A, of D, crank, coupler, rocker, …
  double *u, *v;  ///< one column for each output: of the angle the joint C, which is on the rocker
  const BlockOutput* outputs;
  std::size_t points;
};

struct SampleKernels {
  void (*evaluate)(const BlockTask& task);
  void (*four_bars)(const FourBarTask& task);
  /// Makes the rocker's direction of the place of C in the outputs that are its angle.
  void (*directions)(const FourBarTask& task, std::size_t stations);
  void (*errors)(const ErrorTask& task);
};

#define COGNATE_DECLARE_SAMPLE_KERNELS(name) \
  namespace name {                           \
  SampleKernels sample_kernels();            \
  }
COGNATE_DECLARE_SAMPLE_KERNELS(scalar)
COGNATE_DECLARE_SAMPLE_KERNELS(sse2)
COGNATE_DECLARE_SAMPLE_KERNELS(avx2)
COGNATE_DECLARE_SAMPLE_KERNELS(avx512)
#undef COGNATE_DECLARE_SAMPLE_KERNELS

}  // namespace cognate::tolerance
