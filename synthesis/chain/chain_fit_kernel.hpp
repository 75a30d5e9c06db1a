/// @file The border between chain_fit.cpp and its kernels, compiled for each instruction set: plain
/// values and pointers only, so that no inline function is compiled with wide instructions and then
/// shared.
#pragma once

#include "synthesis/chain/chain.hpp"

namespace cognate::synthesis {

/// A task of the kernel: points in the order in which the crank passes them.
struct ChainFitTask {
  const PlacedLine* line;
  int lines, parameters;
  int trace;    ///< the line of the point that is fitted
  int heading;  ///< of a motion: the line of the heading that is; else below 0
  int points;
  const double *target_x, *target_y, *root_weight;
  const double *heading_x, *heading_y;  ///< of a motion: the direction wanted at each point
  double angle_weight;                  ///< the length that a radian counts
  const double *crank_x, *crank_y;  ///< timed: directions of the crank but for the phase; else null
  bool closed;                      ///< the first point follows the last
  int unknowns;
  const int* unknown;           ///< parameters that are free, ascending
  const double *lower, *upper;  ///< of each of them
  int joints;
  const int* joint;     ///< lines of the dyads whose transmission is limited
  double cosine_limit;  ///< of |cos μ|
  int checks;
  const double *check_x, *check_y;  ///< directions of the crank at which it is; none: at the points
  double penalty;                   ///< weight of what a cosine is beyond the limit, as a residual
  int most_iterations;
  double tolerance, negligible;
  int early, late;               ///< iterations after which a start is given up whose cost is
  double early_cost, late_cost;  ///< more than this
  int starts;
  double* parameter;   ///< in and out: `parameters` numbers of each start
  const double* side;  ///< `lines` numbers of each start
  double* angle;       ///< in and out: crank angles of the points; timed: the phase alone
  double* cost;        ///< out: not a number where a start has none
  int* iterations;     ///< out
  double* workspace;   ///< kChainWorkPerPoint packs of doubles for each point
};

inline constexpr int kChainWorkPerPoint = 8;

#define COGNATE_DECLARE_FIT_CHAINS(name)     \
  namespace name {                           \
  void fit_chains(const ChainFitTask& task); \
  }
COGNATE_DECLARE_FIT_CHAINS(scalar)
COGNATE_DECLARE_FIT_CHAINS(sse2)
COGNATE_DECLARE_FIT_CHAINS(avx2)
COGNATE_DECLARE_FIT_CHAINS(avx512)
#undef COGNATE_DECLARE_FIT_CHAINS

}  // namespace cognate::synthesis
