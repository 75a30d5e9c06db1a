/// @file Motion laws of cam followers, each as smooth pieces.
#pragma once

#include <optional>
#include <vector>

#include "analysis/cam/motion_piece.hpp"

namespace cognate::cam {

/// How displacement goes from one end of a segment to the other.
enum class MotionLaw {
  dwell,
  constant_velocity,
  constant_acceleration,
  harmonic,
  cycloidal,
  polynomial_345,
  polynomial_4567,
  modified_sine,
  modified_trapezoid,
  modified_constant_velocity,  ///< constant over the middle half of the segment
  double_harmonic,             ///< from a dwell to a rise's end without one; a return mirrors it
  universal,                   ///< any symmetric sine–constant–cosine–zero acceleration
  polynomial,                  ///< by boundary conditions
  spline                       ///< through given points
};

/// Shares of the acceleration's course over a segment (Makino's universal curve; Norton's family
/// SCCA where the rest is 0): along a quarter sine up, constant, along a quarter cosine down; what
/// is left of 1 runs at constant velocity about the middle. The second half is antisymmetric.
/// (1/4, 1/2, 1/4) is the modified trapezoid, (1/4, 0, 3/4) the modified sine, (1/2, 0, 1/2)
/// cycloidal, (0, 0, 1) harmonic, (0, 1, 0) constant acceleration, (1/8, 0, 3/8) the modified
/// constant velocity. No share is negative, and their sum is at most 1.
template <class T>
struct UniversalShape {
  T sine{};
  T constant{};
  T cosine{};
};

/// That derivative `order` (0: displacement) has `value` at the share `at` of the segment;
/// derivatives by the cam angle in radians, displacement from the segment's start.
struct MotionCondition {
  double at = 0;
  int order = 0;
  double value = 0;
};

/// A point that a spline passes through.
struct SplinePoint {
  double at = 0;            ///< share of the segment, strictly inside
  double displacement = 0;  ///< from the segment's start
};

/// What happens at the ends of a spline, derivatives by the cam angle in radians.
struct SplineEnds {
  double velocity_begin = 0, velocity_end = 0;
  double acceleration_begin = 0, acceleration_end = 0;  ///< of quintic splines alone
  bool periodic = false;  ///< instead: all derivatives of the end are those of the begin
};

/// One segment of a follower's motion, as a problem file states it.
struct MotionSegment {
  MotionLaw law = MotionLaw::dwell;
  double over = 0;                          ///< cam angle, rad, > 0
  double rise = 0;                          ///< negative in a return, 0 in a dwell
  UniversalShape<double> shape{};           ///< universal
  std::vector<MotionCondition> conditions;  ///< polynomial
  std::vector<SplinePoint> points;          ///< spline, in order
  SplineEnds ends{};                        ///< spline
  int degree = 5;                           ///< spline: 3 or 5
};

/// Greatest velocity, acceleration and jerk of a law for unit rise over unit angle. Infinite where
/// acceleration or velocity jumps (the jerk of constant acceleration).
struct PeakFactors {
  double velocity = 0;
  double acceleration = 0;
  double jerk = 0;
};

/// The factors that handbooks print (Norton, Cam Design and Manufacturing Handbook; Makino).
/// Nothing for laws that have parameters or conditions. The jerk of harmonic motion is π³/2 inside,
/// and infinite at its ends against a dwell; this gives the inside's.
std::optional<PeakFactors> handbook_factors(MotionLaw law);

/// The factors of `segment` as it is, by the exact extremes of its pieces: inside, since what
/// happens at its ends depends on its neighbours (`jumps`). Of a segment without rise they are for
/// its travel; of one that has no pieces, and of a dwell, they are 0.
PeakFactors peak_factors(const MotionSegment& segment);

/// Adds the pieces of `segment`, which begins at the cam angle `begin` with displacement `start`,
/// to `pieces`. Returns false, and adds nothing, where its conditions have no solution or many
/// (polynomial), its points are not in order (spline), or its shares are out of range (universal).
/// The polynomial is the one of least degree: with as many coefficients as conditions, of which the
/// displacement 0 at its begin and `rise` at its end are two unless given otherwise.
bool append_pieces(const MotionSegment& segment, double begin, double start, int index,
                   std::vector<MotionPiece<double>>& pieces);

/// The pieces of a law of acceleration `shape`, as templates so that the shape, the span and the
/// rise may be variables of a design (`T` with derivatives by them); defined in universal_law.hpp,
/// for doubles in the library. A share whose value is 0 has no piece, but what its growth would do
/// to all others is in their derivatives.
template <class T>
void append_universal(const UniversalShape<T>& shape, const T& begin, const T& over, const T& start,
                      const T& rise, int index, std::vector<MotionPiece<T>>& pieces);

}  // namespace cognate::cam
