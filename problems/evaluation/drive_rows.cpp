#include "problems/evaluation/drive_rows.hpp"

#include <cmath>

#include "problems/basics/degrees.hpp"

namespace cognate::problems {
namespace {

double between(double start, double end, int row, int steps) {
  if (row == steps) return end;
  return start + (end - start) * row / steps;
}

}  // namespace

double drive_at(const DriveSweep& sweep, int row) {
  return between(sweep.start, sweep.end, row, sweep.steps);
}

double drive_value(const AnalysisProblem& problem, int row) {
  const DriveSweep& sweep = problem.drive;
  if (driven_by_length(problem.mechanism.mechanism.drive)) {
    return drive_at(sweep, row);
  }
  return between(degrees(sweep.start), degrees(sweep.end), row, sweep.steps);
}

}  // namespace cognate::problems
