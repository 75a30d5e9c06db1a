#include "problems/linkage/error_limit.hpp"

#include <cmath>
#include <numeric>
#include <string_view>

#include "problems/basics/degrees.hpp"
#include "problems/basics/names.hpp"
#include "problems/guidance/scale.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/path/certificate.hpp"
#include "problems/path/scale.hpp"

namespace cognate::problems {
namespace {

/// Of the size of a path or motion, or radians.
constexpr double kMet = 1e-10;

bool is_minimax(const FunctionProblem& problem) {
  return problem.objective == FunctionObjective::minimax;
}

}  // namespace

ErrorMeasure error_measure(const PathProblem& /*problem*/) {
  return ErrorMeasure::rms_length;
}

ErrorMeasure error_measure(const FunctionProblem& problem) {
  return is_minimax(problem) ? ErrorMeasure::largest_angle : ErrorMeasure::rms_angle;
}

ErrorMeasure error_measure(const MotionProblem& /*problem*/) {
  return ErrorMeasure::rms_length;
}

double error_of(const PathProblem& problem, const Design& design) {
  const auto& weights = problem.weights;
  const double total = weights.empty() ? static_cast<double>(problem.points.size())
                                       : std::accumulate(weights.begin(), weights.end(), 0.0);
  return std::sqrt(path_objective(problem, design) / total);
}

double error_of(const FunctionProblem& problem, const Design& design) {
  return is_minimax(problem) ? design.error.max : design.error.rms;
}

double error_of(const MotionProblem& /*problem*/, const Design& design) {
  return design.error.rms;
}

double met_error(const PathProblem& problem) {
  return kMet * PathScale(problem).size;
}

double met_error(const FunctionProblem& /*problem*/) {
  return kMet;
}

double met_error(const MotionProblem& problem) {
  return kMet * MotionScale(problem).size();
}

double shown_error(ErrorMeasure of, double error) {
  return of == ErrorMeasure::rms_length ? error : degrees(error);
}

std::string error_column(ErrorMeasure of) {
  std::string_view key = to_string(of);
  key.remove_suffix(std::string_view("_max").size());
  return std::string(key);
}

void check_error(const ErrorLimit& limit, double error, Design& design) {
  design.constraints.push_back({std::string(to_string(limit.of)), shown_error(limit.of, error),
                                shown_error(limit.of, limit.max),
                                error <= limit.max * (1 + kCheckTolerance)});
}

}  // namespace cognate::problems
