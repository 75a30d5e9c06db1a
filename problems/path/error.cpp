#include "problems/path/error.hpp"

#include <cmath>
#include <numeric>

#include "problems/linkage/error_limit.hpp"
#include "problems/path/certificate.hpp"
#include "problems/path/scale.hpp"

namespace cognate::problems {

ErrorMeasure error_measure(const PathProblem& /*problem*/) {
  return ErrorMeasure::rms_length;
}

double error_of(const PathProblem& problem, const Design& design) {
  const auto& weights = problem.weights;
  const double total = weights.empty() ? static_cast<double>(problem.points.size())
                                       : std::accumulate(weights.begin(), weights.end(), 0.0);
  return std::sqrt(path_objective(problem, design) / total);
}

double met_error(const PathProblem& problem) {
  return kMetError * PathScale(problem).size;
}

}  // namespace cognate::problems
