/// @file The error that a problem of this kind minimises, as one number of a finished design.
#pragma once

#include "problems/linkage/result.hpp"
#include "problems/path/problem.hpp"

namespace cognate::problems {

/// What the error of a problem is: the root mean square distance,
/// squares by their weights. A smaller one means a smaller objective.
ErrorMeasure error_measure(const PathProblem& problem);

/// That error of a design, a length.
double error_of(const PathProblem& problem, const Design& design);

/// Errors up to this are rounding: the target is met.
double met_error(const PathProblem& problem);

}  // namespace cognate::problems
