/// @file A file's bound on the error, and how errors are shown.
#pragma once

#include <string>

#include "problems/linkage/linkage_limits.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// Errors up to this, of the size of a path or motion or in radians, are rounding.
inline constexpr double kMetError = 1e-10;

/// `error` as files say it, in degrees where it is an angle.
double shown_error(ErrorMeasure of, double error);

/// The name of a column of errors, with its unit: "rms_error_deg".
std::string error_column(ErrorMeasure of);

/// Adds to the checks of a design whether `error` is within `limit`.
void check_error(const ErrorLimit& limit, double error, Design& design);

/// Adds that check where the file has such a bound; the kind says what its error is.
template <class AnyProblem>
void check_error(const AnyProblem& problem, Design& design) {
  const auto& limit = problem.constraints.error;
  if (limit) check_error(*limit, error_of(problem, design), design);
}

}  // namespace cognate::problems
