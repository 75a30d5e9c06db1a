/// @file Paths that may be moved, turned and enlarged: `target.place = "similar"`.
///
/// The search stays where the curve is. Given and bounded lengths then count up to one common
/// factor, pivots and the direction of the frame not at all; each linkage found is afterwards put
/// where the file wants it, together with its curve.
#pragma once

#include "analysis/linkage/four_bar.hpp"
#include "problems/linkage/result.hpp"
#include "problems/path/problem.hpp"

namespace cognate::problems {

/// Whether the target of `problem` may be moved.
bool is_movable(const PathProblem& problem);

/// What is searched for: samples without their curve, and of one that may be moved `proportions`
/// for its given and bounded lengths.
PathProblem normalised(const PathProblem& problem);

/// Where the curve comes so that `linkage`, found in its place, meets what the file gives. What is
/// left open changes as little as can be: the scale is the nearest to 1, the turn the nearest to 0,
/// both about the origin, which stays where no pivot is given.
CurvePlacement placement_of(const PathProblem& problem, const FourBar& linkage);

/// `linkage` at that place, given dimensions to the last digit.
FourBar placed(const PathProblem& problem, const FourBar& linkage, const CurvePlacement& placement);

}  // namespace cognate::problems
