#include "problems/function/error.hpp"

#include "problems/linkage/error_limit.hpp"

namespace cognate::problems {
namespace {

bool is_minimax(const FunctionProblem& problem) {
  return problem.objective == FunctionObjective::minimax;
}

}  // namespace

ErrorMeasure error_measure(const FunctionProblem& problem) {
  return is_minimax(problem) ? ErrorMeasure::largest_angle : ErrorMeasure::rms_angle;
}

double error_of(const FunctionProblem& problem, const Design& design) {
  return is_minimax(problem) ? design.error.max : design.error.rms;
}

double met_error(const FunctionProblem& /*problem*/) {
  return kMetError;
}

}  // namespace cognate::problems
