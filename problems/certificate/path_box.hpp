/// @file Whether every linkage of a box errs by a bound at least at a timed path, in intervals of
/// 113 bits.
///
/// A coupler point is t + s e + q u, e the crank's direction and u the coupler's; with t, s and the
/// complex q eliminated the sum of squares Z − |b(u)|²/U(u) is at least F where
///
///     H(u) = (Z − F) U(u) − |b(u)|² ≥ 0.
///
/// Over a box u is its value at the middle, turned by angles that the derivatives of
/// link_angles.hpp enclose: affine in the place up to a rest, so that H is a quadratic of four
/// variables (see box_form.hpp) up to the rest's part. Limits of s and q enter with Lagrange
/// multipliers.
#pragma once

#include <optional>
#include <vector>

#include "problems/certificate/box_form.hpp"
#include "problems/certificate/box_limits.hpp"
#include "problems/certificate/path_question.hpp"
#include "problems/path/problem.hpp"

namespace cognate::problems {

/// What is shown of a box.
struct BoxFinding {
  bool shown = false;  ///< no linkage of it is better than the bound
  int side = 0;        ///< else: which is best halved
};

/// A linkage that errs by less than a bound said to hold for it.
struct Counterexample {
  FourBar linkage;
  double first_crank_angle = 0;  ///< at the first point, from the x axis
  double error = 0;
};

class PathBoxes {
 public:
  /// Of a path with prescribed timing, its crank turning clockwise or not, and a bound in the
  /// file's unit, squared.
  PathBoxes(const PathProblem& problem, bool clockwise, double bound);

  BoxFinding operator()(const QuadBox& box) const;
  /// The best linkage with the proportions and the phase in the middle of `box`, if it is better
  /// than the bound: its error is that of `path_error`, not of any form.
  std::optional<Counterexample> counterexample(const QuadBox& box) const;

 private:
  struct Directions;
  struct Sums;
  struct Multipliers;

  Directions directions(const LinkAngles& angles, const QuadBox& box) const;
  Sums sums(const Directions& directions) const;
  Multipliers multipliers(const Sums& sums, const QuadInterval& crank, double on_point) const;
  Multipliers multipliers_within(const Sums& sums, const QuadInterval& crank) const;
  FourBar linkage(const QuadBox& point, const Directions& directions, const Multipliers& at) const;
  std::optional<double> lacks(const Directions& directions, const Sums& sums,
                              const Multipliers& multipliers) const;
  bool is_shown(const Directions& directions, const QuadInterval& crank) const;

  PathQuestion question_;
  BoxLimits limits_;
  double farthest_ = 0;
  double bound_ = 0;
};

}  // namespace cognate::problems
