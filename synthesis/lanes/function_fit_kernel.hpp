/// @file The border between function_fit.cpp and its kernels, compiled for each instruction set:
/// plain values and pointers only, so that no inline function is compiled with wide instructions
/// and then shared.
#pragma once

#include "synthesis/bounds/link_limit.hpp"

namespace cognate::synthesis {

/// The unknowns of a function generator, in this order.
enum FunctionUnknown {
  function_crank,
  function_coupler,
  function_rocker,
  function_frame,
  function_input_start,
  function_output_start,
  function_unknowns
};

/// Numbers of a start: four lengths, the directions of half the input start angle and of the output
/// start angle, and the assembly (±1).
inline constexpr int kFunctionStateSize = 4 + 2 + 2 + 1;

/// The desired pairs of angles: directions of half the input's and of the output's
/// increments.
struct FunctionTargets {
  int samples;
  const double *half_input_x, *half_input_y;
  const double *output_x, *output_y;
};

struct FunctionScreenTask {
  FunctionTargets targets;
  long count;  ///< a multiple of eight
  const double *crank, *coupler, *rocker, *frame, *half_start_x, *half_start_y;
  const double *output_start_x, *output_start_y;  ///< null: the best for each
  double *open, *crossed;  ///< out: mean square of the errors' chords; NaN if it does not close
};

struct FreudensteinTask {
  FunctionTargets targets;
  int reweightings;
  long count;                                             ///< a multiple of eight
  const double *input_x, *input_y, *output_x, *output_y;  ///< directions of the start angles
  double* ratio[3];                                       ///< out: P₀, P₁, P₂
};

struct FunctionFitTask {
  FunctionTargets targets;
  int unknowns;                 ///< that are free
  const int* unknown;           ///< which they are, ascending
  const double *lower, *upper;  ///< of each of them that is a length
  const LinkLimit* limits;
  int limit_count;
  bool limits_transmission;  ///< at the samples
  double least_cosine, greatest_cosine;
  double penalty;  ///< weight of the violation of a limit, as a residual
  int most_iterations;
  double tolerance, negligible;
  int starts;
  double* state;    ///< kFunctionStateSize numbers of each, replaced by what was reached
  double* cost;     ///< out: sum of squares with penalties; not a number where it has none
  int* iterations;  ///< out
};

#define COGNATE_DECLARE_FUNCTION_KERNELS(name)           \
  namespace name {                                       \
  void fit_freudenstein(const FreudensteinTask& task);   \
  void screen_functions(const FunctionScreenTask& task); \
  void fit_functions(const FunctionFitTask& task);       \
  }
COGNATE_DECLARE_FUNCTION_KERNELS(scalar)
COGNATE_DECLARE_FUNCTION_KERNELS(sse2)
COGNATE_DECLARE_FUNCTION_KERNELS(avx2)
COGNATE_DECLARE_FUNCTION_KERNELS(avx512)
#undef COGNATE_DECLARE_FUNCTION_KERNELS

}  // namespace cognate::synthesis
