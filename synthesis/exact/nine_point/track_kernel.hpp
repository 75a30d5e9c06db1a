/// @file The border between the portable code of the homotopy and the kernels that follow its
/// paths, compiled for each instruction set and for double-double numbers: plain values and
/// pointers only, so that no inline function is compiled with wide instructions and then shared.
#pragma once

namespace cognate::synthesis::nine_point {

inline constexpr int kPivots = 8;     ///< x, x̄, a, ā of the first dyad, then of the second
inline constexpr int kPositions = 8;  ///< at most: displacements from the reference
inline constexpr int kPoses = 4;      ///< at most, beside the reference

/// A complex number in memory.
struct Pair {
  double re = 0, im = 0;
};

/// value = at_end + r·slope for r from 1 at the start to 0 at the end.
struct LinearPair {
  Pair at_end, slope;
};

/// The data along a path: straight lines for displacements, and for the rotation of a pose the
/// quotient of two of them, neither of which comes near zero. Poses come before points.
struct ParameterLine {
  LinearPair d[kPositions], d_bar[kPositions];
  LinearPair turn_above[kPoses], turn_below[kPoses];
};

/// Tolerances relative to 1 + |unknown|, of rotations relative to their size.
struct TrackSettings {
  double prediction = 1e-3;   ///< estimated error of the prediction that a step aims at
  double correction = 1e-2;   ///< largest first Newton correction of a step that is accepted
  double contraction = 1e-2;  ///< largest second one for a first one of `correction`
  double noise = 1e-8;        ///< second corrections below are accepted in any case
  double least_step = 1e-13;  ///< of r
  double infinite = 1e12;     ///< pivots beyond are taken to be at infinity
  int most_steps = 1500;
};

/// How a path ended.
enum class PathEnd : int {
  unfinished,  ///< stopped from outside
  reached,     ///< r = 0
  infinite,    ///< a pivot has left for infinity
  stuck,       ///< the step became too small, or there were too many of them
};

/// Unknowns of a path, in `starts` and `ends`: kPivots pivots, then a rotation for each point.
constexpr int unknowns(int points) {
  return kPivots + points;
}

struct TrackTask {
  int points;  ///< without orientation; (8 − points)/2 poses
  const Pair* starts;
  const double* from;  ///< r at each start
  const int* line_of;  ///< index into `lines` for each path
  const ParameterLine* lines;
  TrackSettings settings;
  int (*next)(void* context);      ///< index of a path to follow; negative if there is none left
  bool (*stopped)(void* context);  ///< asked now and then
  void* context;
  Pair* ends;         ///< where each path ended, or was left
  PathEnd* how;       ///< of each path
  double* remaining;  ///< r of each path where it ended
  int* steps;         ///< of each path
};

/// Roots to look at, all of the same data: `data` where r = 0. What is null is not computed.
struct InspectTask {
  int points;
  const ParameterLine* data;
  const Pair* roots;   ///< unknowns(points) numbers each
  int first, last;     ///< those to look at
  const Pair* given;   ///< values of the equations to correct for; null: those in own precision
  Pair* values;        ///< of the equations: two for each of kPositions positions
  Pair* changes;       ///< Newton's correction of the unknowns, of rotations relative to them
  double* conditions;  ///< Frobenius norm of the derivative of the pivots by the data
};

// track() follows the paths that `next` hands out, one in each lane, until there are none.
#define COGNATE_DECLARE_TRACK(name)      \
  namespace name {                       \
  void track(const TrackTask& task);     \
  void inspect(const InspectTask& task); \
  }
COGNATE_DECLARE_TRACK(scalar)
COGNATE_DECLARE_TRACK(sse2)
COGNATE_DECLARE_TRACK(avx2)
COGNATE_DECLARE_TRACK(avx512)
COGNATE_DECLARE_TRACK(double_double)
#undef COGNATE_DECLARE_TRACK

}  // namespace cognate::synthesis::nine_point
