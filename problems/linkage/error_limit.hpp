/// @file The error that a problem of path, function or motion generation minimises, as one number
/// of a finished design, and a file's bound on it.
#pragma once

#include <string>

#include "problems/function/problem.hpp"
#include "problems/guidance/problem.hpp"
#include "problems/linkage/linkage_limits.hpp"
#include "problems/linkage/result.hpp"
#include "problems/path/problem.hpp"

namespace cognate::problems {

/// What the error of a problem is: the root mean square distance of a path (squares by their
/// weights) or of a motion (angles by theirs); of a function that of the angles, or the largest one
/// where the objective is minimax. A smaller one means a smaller objective.
ErrorMeasure error_measure(const PathProblem& problem);
ErrorMeasure error_measure(const FunctionProblem& problem);
ErrorMeasure error_measure(const MotionProblem& problem);

/// That error of a design, a length or radians.
double error_of(const PathProblem& problem, const Design& design);
double error_of(const FunctionProblem& problem, const Design& design);
double error_of(const MotionProblem& problem, const Design& design);

/// Errors up to this are rounding: the target is met.
double met_error(const PathProblem& problem);
double met_error(const FunctionProblem& problem);
double met_error(const MotionProblem& problem);

/// `error` as files say it, in degrees where it is an angle.
double shown_error(ErrorMeasure of, double error);

/// The name of a column of errors, with its unit: "rms_error_deg".
std::string error_column(ErrorMeasure of);

/// Adds to the checks of a design whether `error` keeps to `limit`.
void check_error(const ErrorLimit& limit, double error, Design& design);

/// Adds that check where the file has such a bound.
template <class AnyProblem>
void check_error(const AnyProblem& problem, Design& design) {
  const auto& limit = problem.constraints.error;
  if (limit) check_error(*limit, error_of(problem, design), design);
}

}  // namespace cognate::problems
