/// @file The error that a problem of this kind minimises, as one number of a finished design.
#pragma once

#include "problems/function/problem.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// What the error of a problem is: the root mean square of the angles,
/// or the largest one where the objective is minimax. A smaller one means a smaller objective.
ErrorMeasure error_measure(const FunctionProblem& problem);

/// That error of a design, radians.
double error_of(const FunctionProblem& problem, const Design& design);

/// Errors up to this are rounding: the target is met.
double met_error(const FunctionProblem& problem);

}  // namespace cognate::problems
