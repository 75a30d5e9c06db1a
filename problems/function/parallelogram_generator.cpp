#include "problems/function/parallelogram_generator.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "analysis/numbers/constants.hpp"
#include "problems/basics/degrees.hpp"

namespace cognate::problems {
namespace {

/// Angles that differ by less turn alike.
constexpr double kSameAngle = 1e-8;

/// Frame over crank: the shape of a parallelogram is free, a rhombus may fold onto itself.
constexpr double kFrameToCrank = 2;

bool turns(const FunctionSamples& wanted, const EqualTurning& turning) {
  const auto follows = [&](double input, double output) {
    return std::abs(wrapped(output - turning.sense * input - turning.offset)) <= kSameAngle;
  };
  for (const auto& pair : wanted.samples) {
    if (!follows(pair.input, pair.output)) return false;
  }
  for (const auto& point : wanted.precision) {
    if (!follows(point.input, point.output[0])) return false;
    for (std::size_t k = 1; k < point.multiplicity; ++k) {
      const double derivative = k == 1 ? turning.sense : 0;
      if (!(std::abs(point.output[k] - derivative) <= kSameAngle)) return false;
    }
  }
  return true;
}

/// The angle of `bounds` nearest to `angle`, whole turns aside.
double nearest_within(const std::optional<Range>& bounds, double angle) {
  if (!bounds) return angle;
  const double middle = 0.5 * (bounds->min + bounds->max);
  return std::clamp(middle + wrapped(angle - middle), bounds->min, bounds->max);
}

double within(const std::optional<Range>& bounds, double length) {
  return bounds ? std::clamp(length, bounds->min, bounds->max) : length;
}

Lengths<double> lengths_of(const FunctionProblem& problem) {
  const Given& given = problem.given;
  const double crank = given.crank.value_or(given.frame.value_or(kFrameToCrank) / kFrameToCrank);
  const double frame = given.frame.value_or(
      within(problem.bounds.frame, within(problem.bounds.coupler, kFrameToCrank * crank)));
  return {crank, frame, crank, frame};
}

}  // namespace

std::optional<EqualTurning> equal_turning(const FunctionSamples& wanted) {
  const auto& first = wanted.precision.front();
  for (const double sense : {1.0, -1.0}) {
    const EqualTurning turning{sense, wrapped(first.output[0] - sense * first.input)};
    if (turns(wanted, turning)) return turning;
  }
  return std::nullopt;
}

std::optional<FunctionGenerator> parallelogram(const FunctionProblem& problem,
                                               const FunctionSamples& wanted, double offset) {
  const double across = kRightAngle - 0.5 * (wanted.sweep.min + wanted.sweep.max);
  FunctionGenerator generator;
  generator.links = lengths_of(problem);
  if (problem.input_start || !problem.output_start) {
    generator.input_start =
        problem.input_start.value_or(nearest_within(problem.input_start_bounds, across));
    generator.output_start = problem.output_start.value_or(
        nearest_within(problem.output_start_bounds, generator.input_start - offset));
    // Bounds on the output's start alone leave the input's to follow.
    if (!problem.input_start) generator.input_start = generator.output_start + offset;
  } else {
    generator.output_start = *problem.output_start;
    generator.input_start = generator.output_start + offset;
  }
  const double apart = wrapped(generator.input_start - generator.output_start - offset);
  return std::abs(apart) <= kSameAngle ? std::optional(generator) : std::nullopt;
}

std::string equal_turning_note(const EqualTurning& turning) {
  if (turning.sense < 0) {
    return "The output turns by the angle of the input in the other sense: no four-bar with finite "
           "links does so exactly over a range, the limit being one with frame and coupler "
           "infinitely long; a pair of equal gears does.";
  }
  return fmt::format(
      "The output turns with the input by the same angle: any parallelogram does so, but it starts "
      "with input_start_deg = output_start_deg{}; leave one of the two out, or give them so.",
      std::abs(turning.offset) <= kSameAngle
          ? ""
          : fmt::format(" {} {:.10g}", turning.offset < 0 ? "-" : "+",
                        degrees(std::abs(turning.offset))));
}

}  // namespace cognate::problems
