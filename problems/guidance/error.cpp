#include "problems/guidance/error.hpp"

#include "problems/guidance/scale.hpp"
#include "problems/linkage/error_limit.hpp"

namespace cognate::problems {

ErrorMeasure error_measure(const MotionProblem& /*problem*/) {
  return ErrorMeasure::rms_length;
}

double error_of(const MotionProblem& /*problem*/, const Design& design) {
  return design.error.rms;
}

double met_error(const MotionProblem& problem) {
  return kMetError * MotionScale(problem).size();
}

}  // namespace cognate::problems
