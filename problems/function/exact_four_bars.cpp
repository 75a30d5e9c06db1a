#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "problems/function/designs.hpp"
#include "problems/function/exact_generators.hpp"
#include "problems/function/generator.hpp"
#include "problems/linkage/prevailing_side.hpp"
#include "synthesis/exact/function/four_bar_function.hpp"

namespace cognate::problems {
namespace {

using synthesis::FourBarFunction;
using synthesis::FourBarOutcome;
using synthesis::GivenStart;
using synthesis::PrecisionPoint;

std::string why_no_linkage(const FourBarFunction& found, const std::string& pairs) {
  switch (found.outcome) {
    case FourBarOutcome::no_coupler:
      return fmt::format("No linkage passes through the {}: the coupler comes out with no length.",
                         pairs);
    case FourBarOutcome::infinite_rocker:
      return fmt::format(
          "One solution through the {} is no four-bar: its coupler and rocker come out infinitely "
          "long, which is a guide-bar with crank 1, frame {:.10g} and offset {:.10g}.",
          pairs, found.links.frame, found.guide_offset);
    case FourBarOutcome::infinite_crank:
      return fmt::format(
          "One solution through the {} is no four-bar: its crank and coupler come out infinitely "
          "long, which is a guide-bar driven by its guide, with rocker 1 and frame {:.10g}.",
          pairs, found.links.frame);
    case FourBarOutcome::rigid:
      return fmt::format(
          "No linkage passes through the {}: the output turns with the input as one body.", pairs);
    case FourBarOutcome::infinite_frame:
      return fmt::format(
          "No linkage passes through the {}: the frame comes out infinitely long, the projections "
          "of input and output link on one line staying in step.",
          pairs);
    case FourBarOutcome::linkage:
      break;
  }
  return {};
}

/// Lengths with crank 1 in the file's unit.
Lengths<double> scaled(const Lengths<double>& links, const Given& given) {
  const double factor =
      given.crank ? *given.crank : given.frame.value_or(links.frame) / links.frame;
  return {given.crank.value_or(factor * links.crank), factor * links.coupler, factor * links.rocker,
          given.frame.value_or(factor * links.frame)};
}

/// Where the linkage does not close over the whole range, its error is that at the pairs it meets.
TargetError at_points(const FunctionGenerator& generator,
                      const std::vector<CrankPosition>& positions,
                      const std::vector<PrecisionPoint>& points) {
  TargetError error;
  for (std::size_t i = 0; i < points.size(); ++i) {
    FunctionGenerator own = generator;
    own.assembly = positions[i].side;
    const double off = StructuralError(own).at({points[i].input, points[i].output[0]}).value_or(0);
    error.sum_of_squares += off * off;
    error.max = std::max(error.max, std::abs(off));
  }
  error.rms = std::sqrt(error.sum_of_squares / static_cast<double>(points.size()));
  return error;
}

}  // namespace

ExactDesigns exact_four_bars(const FunctionProblem& problem, const FunctionSamples& wanted,
                             const GivenStart& start) {
  const auto found = synthesis::four_bar_functions(wanted.precision, start);
  const std::size_t count = condition_count(wanted.precision);
  ExactDesigns result;
  result.dependent = found.dependent;
  result.solutions = found.solutions.size();
  const std::string conditions = conditions_in_words(wanted);
  for (const FourBarFunction& solution : found.solutions) {
    if (solution.outcome != FourBarOutcome::linkage) {
      note_once(result.notes, why_no_linkage(solution, conditions));
      continue;
    }
    FunctionGenerator generator;
    generator.links = scaled(solution.links, problem.given);
    generator.input_start = solution.input_start;
    generator.output_start = solution.output_start;
    const auto positions = sides_at(generator, wanted.precision);
    generator.assembly = prevailing_side(positions, &CrankPosition::side);
    Design design = function_design(problem, wanted, generator, positions,
                                    fmt::format("exact:freudenstein-{}", count));
    const bool closes = StructuralError(generator).closes_over(wanted.sweep);
    if (!closes || !std::isfinite(design.error.sum_of_squares)) {
      design.error = at_points(generator, positions, wanted.precision);
    }
    design.metrics.precision_residual = solution.residual;
    design.metrics.condition = solution.condition;
    result.designs.push_back(std::move(design));
  }
  return result;
}

}  // namespace cognate::problems
