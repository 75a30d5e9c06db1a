#include "problems/chain_function/verify.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/chain/output/body.hpp"
#include "problems/chain/verify.hpp"
#include "problems/function/error_peaks.hpp"
#include "problems/function/slider_generator.hpp"
#include "problems/linkage/error_limit.hpp"

namespace cognate::problems {
namespace {

using synthesis::AnglePair;

constexpr double kNone = std::numeric_limits<double>::infinity();

/// At the samples, the greatest also between them.
TargetError errors_over(const FunctionSamples& wanted, const ChainFunctionError& error) {
  TargetError total;
  const auto magnitude = [&](const AnglePair& pair) { return std::abs(error.at(pair)); };
  for (const AnglePair& pair : wanted.samples) {
    const double here = magnitude(pair);
    total.sum_of_squares += here * here;
    total.max = std::max(total.max, here);
  }
  total.rms = std::sqrt(total.sum_of_squares / double(wanted.samples.size()));
  if (!std::isfinite(total.sum_of_squares)) return {kNone, kNone, kNone};
  for (const AnglePair& peak : error_peaks(magnitude, wanted, {})) {
    total.max = std::max(total.max, magnitude(peak));
  }
  return total;
}

AssemblyRanges limited_motion(const ChainFunctionProblem& problem, const FunctionSamples& wanted,
                              const NamedMechanism& mechanism, double start) {
  if (problem.constraints.over == LimitSpan::turn) return follow(mechanism.mechanism, 0, kTurn);
  return follow(mechanism.mechanism, start + wanted.sweep.min, start + wanted.sweep.max);
}

}  // namespace

ErrorMeasure error_measure(const ChainFunctionProblem& problem) {
  if (problem.objective == FunctionObjective::minimax) {
    return slides(problem) ? ErrorMeasure::largest_length : ErrorMeasure::largest_angle;
  }
  return slides(problem) ? ErrorMeasure::rms_length : ErrorMeasure::rms_angle;
}

double error_of(const ChainFunctionProblem& problem, const Design& design) {
  return problem.objective == FunctionObjective::minimax ? design.error.max : design.error.rms;
}

ChainFunctionError::ChainFunctionError(const ChainFunctionProblem& problem,
                                       const FunctionSamples& wanted,
                                       const NamedMechanism& mechanism, double start)
    : start_(start), motion_(mechanism.mechanism) {
  if (slides(problem)) guide_ = guide_of(mechanism, problem.output[1]);
  for (std::size_t i = guide_ ? 1 : 0; i < 2; ++i) {
    points_.at(i) =
        std::ranges::find(mechanism.points, problem.output.at(i), &NamedPoint::name)->at;
  }
  const AnglePair& first = wanted.samples.front();
  level_ = output(first.input).value_or(kNone) - first.output;
  double sum = 0, least = kNone, greatest = -kNone;
  for (const AnglePair& pair : wanted.samples) {
    const double error = at(pair);
    sum += error;
    least = std::min(least, error);
    greatest = std::max(greatest, error);
  }
  level_ += problem.objective == FunctionObjective::minimax ? 0.5 * (least + greatest)
                                                            : sum / double(wanted.samples.size());
}

std::optional<double> ChainFunctionError::output(double input) const {
  if (!motion_.move_to(start_ + input)) return std::nullopt;
  const Vec2d to = motion_.point(points_[1]);
  if (guide_) return dot(guide_->direction, to - guide_->through);
  return angle_of(to - motion_.point(points_[0]));
}

double ChainFunctionError::at(const AnglePair& pair) const {
  const auto here = output(pair.input);
  if (!here) return kNone;
  const double error = *here - pair.output - level_;
  return guide_ ? error : std::remainder(error, kTurn);
}

TargetError function_error(const ChainFunctionProblem& problem, const FunctionSamples& wanted,
                           const NamedMechanism& mechanism, double start) {
  return errors_over(wanted, ChainFunctionError(problem, wanted, mechanism, start));
}

Design verified(const ChainFunctionProblem& problem, const FunctionSamples& wanted,
                const Topology& topology, NamedMechanism mechanism, double start) {
  Design design;
  design.metrics.quantities.push_back({"topology", topology.name});
  const ChainFunctionError error(problem, wanted, mechanism, start);
  design.error = errors_over(wanted, error);
  design.metrics.input_start = in_one_turn(start);
  if (slides(problem)) {
    design.metrics.quantities.push_back(quantity(kSliderStartKey, error.output_start()));
  } else {
    design.metrics.output_start = in_one_turn(error.output_start());
  }
  const AssemblyRanges motion = limited_motion(problem, wanted, mechanism, start);
  measure_transmission(topology, mechanism, motion, design.metrics);
  check_transmission(problem.constraints.transmission_angle, design);
  check_circuit(topology, mechanism, motion, design);
  check_error(problem, design);
  for (const AnglePair& pair : wanted.samples) {
    design.crank_angles.push_back(in_one_turn(start + pair.input));
  }
  mechanism.output = output_body(topology, problem.output);
  design.mechanism = std::move(mechanism);
  return design;
}

}  // namespace cognate::problems
