/// @file The border between path_proof.cpp and its kernels, compiled for each instruction set:
/// plain values and pointers only.
#pragma once

namespace cognate::synthesis {

/// Numbers of a box, one after the other; `kProofBoxes` boxes stand side by side.
enum ProofNumber {
  proof_k,
  proof_half_k,
  proof_side,      ///< +1 where k ≥ 1/2, −1 where k ≤ 1/2
  proof_assembly,  ///< ±1
  proof_angles,  ///< of ξ, η and the phase: half width, sine and cosine of half the middle and of
                 ///< half that width
  proof_numbers = proof_angles + 15
};
inline constexpr int kProofBoxes = 64;
/// Bytes to which the working memory of a kernel is aligned, and doubles of it for each sample.
inline constexpr int kProofAlignment = 64;
inline constexpr int kProofWorkPerSample = 8 * 64;

struct PathProofTask {
  int samples;
  /// Of half the crank angle of each where the phase is zero, and of the whole angle.
  const double *half_sine, *half_cosine, *sine, *cosine;
  const double *x, *y, *weight;   ///< points, relative to their centre unless the pivot is fixed
  double mean_sine, mean_cosine;  ///< of the crank angles
  bool pivot_fixed;
  double farthest_point;        ///< greatest |q|, possibly infinite
  double target, first_target;  ///< errors to exceed; the second is no more than the first
  int boxes;                    ///< a multiple of 8, at most kProofBoxes
  const double* box;            ///< proof_numbers × kProofBoxes
  int* reached;  ///< out: 2 where the error is proved to exceed the target, 1 the first, else 0
  int* side;     ///< out: which is best halved
  double* workspace;  ///< kProofWorkPerSample doubles for each sample
};

#define COGNATE_DECLARE_PROVE_PATHS(name)      \
  namespace name {                             \
  void prove_paths(const PathProofTask& task); \
  }
COGNATE_DECLARE_PROVE_PATHS(scalar)
COGNATE_DECLARE_PROVE_PATHS(sse2)
COGNATE_DECLARE_PROVE_PATHS(avx2)
COGNATE_DECLARE_PROVE_PATHS(avx512)
#undef COGNATE_DECLARE_PROVE_PATHS

}  // namespace cognate::synthesis
