/// @file What a timed path asks, read from the problem anew for the check of its certificate.
#pragma once

#include <array>
#include <vector>

#include "analysis/linkage/four_bar.hpp"
#include "problems/certificate/link_angles.hpp"
#include "problems/path/problem.hpp"

namespace cognate::problems {

struct PathQuestion {
  std::vector<QuadComplex> points;  ///< from the crank's pivot where that is given
  std::vector<CrankAngle> angles;   ///< from the crank's direction at angle zero
  std::vector<double> weights;
  Vec2d origin;       ///< in the plane
  double turned = 0;  ///< by which `points` are turned about it, counter-clockwise
  bool pivot_fixed = false;
  bool direction_fixed = false;  ///< whether that direction is the x axis of `points`
};

PathQuestion path_question(const PathProblem& problem, bool clockwise);

/// The weighted sum of squared distances of a linkage whose crank has the angle `zero` in the plane
/// where `question.angles` are zero, in 113 bits: C is where two circles meet. Infinite where they
/// do not.
double path_error(const PathQuestion& question, const FourBar& linkage, double zero);

/// Limits of crank, coupler, rocker and frame.
std::array<Range, 4> path_lengths(const PathProblem& problem);
/// The greatest ratio of two lengths that the domain of the certificate holds.
double path_ratio(const PathProblem& problem);
/// The greatest distance of the coupler point from B that it holds.
double path_farthest(const PathProblem& problem);

}  // namespace cognate::problems
