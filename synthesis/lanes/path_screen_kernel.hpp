/// @file The border between path_screen.cpp and the kernels compiled for each instruction set:
/// plain pointers only, so that no inline function is compiled with wide instructions and then
/// shared.
#pragma once

namespace cognate::synthesis {

struct SeparableTarget;

struct PathCandidateArrays {
  const double *coupler, *rocker, *frame, *phase_cos, *phase_sin;
  double *open, *crossed;
  unsigned long count;
};

using ScreenKernel = void (*)(const SeparableTarget&, const PathCandidateArrays&);

void screen_sse2(const SeparableTarget& target, const PathCandidateArrays& candidates);
void screen_avx2(const SeparableTarget& target, const PathCandidateArrays& candidates);
void screen_avx512(const SeparableTarget& target, const PathCandidateArrays& candidates);

}  // namespace cognate::synthesis
