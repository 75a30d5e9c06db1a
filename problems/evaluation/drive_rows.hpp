/// @file The drive's coordinate at each row of an analysis.
#pragma once

#include "problems/evaluation/problem.hpp"

namespace cognate::problems {

/// The number of rows: both ends are included.
inline int row_count(const DriveSweep& sweep) {
  return sweep.steps + 1;
}

/// The drive's coordinate at `row`, in radians or length; the ends are exact.
double drive_at(const DriveSweep& sweep, int row);

/// The same for people and files: a length as it is, an angle in degrees, exact where the file's
/// degrees are.
double drive_value(const AnalysisProblem& problem, int row);

}  // namespace cognate::problems
