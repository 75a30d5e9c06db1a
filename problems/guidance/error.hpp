/// @file The error that a problem of this kind minimises, as one number of a finished design.
#pragma once

#include "problems/guidance/problem.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// What the error of a problem is: the root mean square distance,
/// angles by their weight. A smaller one means a smaller objective.
ErrorMeasure error_measure(const MotionProblem& problem);

/// That error of a design, a length.
double error_of(const MotionProblem& problem, const Design& design);

/// Errors up to this are rounding: the target is met.
double met_error(const MotionProblem& problem);

}  // namespace cognate::problems
