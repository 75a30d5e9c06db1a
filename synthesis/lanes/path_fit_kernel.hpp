/// @file The border between path_fit.cpp and its kernels, compiled for each instruction set: plain
/// values and pointers only, so that no inline function is compiled with wide instructions and then
/// shared.
#pragma once

#include "synthesis/bounds/link_limit.hpp"

namespace cognate::synthesis {

/// The unknowns of a path problem that are the same for all points, in this order.
enum PathUnknown {
  path_crank,
  path_coupler,
  path_rocker,
  path_frame,
  path_point_u,
  path_point_v,
  path_anchor_x,
  path_anchor_y,
  path_frame_angle,
  path_phase,
  path_unknowns
};

/// Numbers of a start in addition to its points: the unknowns but for the two angles, then the
/// direction of the frame, that of half the phase, and the assembly (±1).
inline constexpr int kPathStateSize = 8 + 2 + 2 + 1;

/// Bytes to which the working memory of a kernel is aligned, and doubles of it for each point.
inline constexpr int kLaneAlignment = 64;
inline constexpr int kPathWorkPerPoint = 8 * (2 + 2 + path_unknowns + 2);

struct PathFitTask {
  int points;
  const double *target_x, *target_y, *root_weight;
  int unknowns;                   ///< that are free
  const int* unknown;             ///< which they are, ascending
  const double *lower, *upper;    ///< of each of them; infinite where there is no bound
  const unsigned char* is_timed;  ///< of each point: its crank angle is fixed but for the phase
  bool any_free;                  ///< whether a point is not timed
  bool counted_from_x;  ///< crank angles of timed points are from the x axis, not from the frame
  bool anchored_at_d;   ///< the anchor is D, not A
  const LinkLimit* limits;
  int limit_count;
  double box[4];  ///< x and y limits of the pivot that is not the anchor: min, max of each
  bool boxed;     ///< whether one of them is finite
  /// Limits of cos μ at each point, μ being the transmission angle, and whether there are any.
  double least_cosine, greatest_cosine;
  bool limits_transmission;
  double penalty;  ///< weight of the violation of a limit, as a residual
  int most_iterations;
  double tolerance;
  double negligible;
  // Starts: state and half directions of the crank (x, y for each point) of each, replaced by what
  // was reached.
  int starts;
  double *state, *crank_half;
  double* cost;     ///< out: weighted sum of squares with penalties; not a number where it has none
  int* iterations;  ///< out
  double* workspace;  ///< kPathWorkPerPoint doubles for each point
};

#define COGNATE_DECLARE_FIT_PATHS(name)    \
  namespace name {                         \
  void fit_paths(const PathFitTask& task); \
  }
COGNATE_DECLARE_FIT_PATHS(scalar)
COGNATE_DECLARE_FIT_PATHS(sse2)
COGNATE_DECLARE_FIT_PATHS(avx2)
COGNATE_DECLARE_FIT_PATHS(avx512)
#undef COGNATE_DECLARE_FIT_PATHS

}  // namespace cognate::synthesis
