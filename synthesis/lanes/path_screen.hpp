/// @file Screening of many designs for timed paths, one design for each SIMD lane.
#pragma once

#include <cstddef>
#include <vector>

#include "synthesis/lanes/separable_path.hpp"

namespace cognate::synthesis {

/// Designs as a structure of arrays, lengths with crank = 1. The size is a multiple of `lanes`.
struct PathCandidates {
  static constexpr std::size_t lanes = 8;
  explicit PathCandidates(std::size_t count)
      : coupler(count),
        rocker(count),
        frame(count),
        phase_cos(count),
        phase_sin(count),
        open(count),
        crossed(count) {}
  std::vector<double> coupler, rocker, frame;
  std::vector<double> phase_cos, phase_sin;  ///< of half the phase
  std::vector<double> open, crossed;         ///< out: least weighted sum of squares, or NaN
};

/// Fills `open` and `crossed` with separable_fit(…).error of every candidate, on the widest
/// instruction set of this machine (SSE2, AVX2 + FMA or AVX-512; scalar elsewhere).
void screen(const SeparableTarget& target, PathCandidates& candidates);

/// The instruction set that screen() uses here: "scalar", "sse2", "avx2" or "avx512".
const char* screen_instruction_set();

}  // namespace cognate::synthesis
