#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "analysis/linkage/slider_crank_mobility.hpp"
#include "analysis/numbers/angle.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/function/designs.hpp"
#include "problems/function/exact_generators.hpp"
#include "problems/function/slider_generator.hpp"
#include "problems/linkage/prevailing_side.hpp"
#include "problems/linkage/verify.hpp"
#include "synthesis/exact/function/slider_crank_function.hpp"

namespace cognate::problems {
namespace {

using synthesis::GivenStart;
using synthesis::SliderCrankFunction;
using synthesis::SliderCrankOutcome;

std::string why_no_mechanism(const SliderCrankFunction& found, const std::string& pairs) {
  switch (found.outcome) {
    case SliderCrankOutcome::no_coupler:
      return fmt::format(
          "No slider-crank passes through the {}: the coupler comes out with no length.", pairs);
    case SliderCrankOutcome::no_crank:
      return fmt::format(
          "No slider-crank passes through the {}: the crank comes out with no length.", pairs);
    case SliderCrankOutcome::scotch_yoke:
      return fmt::format(
          "The {} are those of a Scotch yoke with crank {:.10g}: the coupler of the slider-crank "
          "would be infinitely long.",
          pairs, found.crank);
    case SliderCrankOutcome::infinite_links:
      return fmt::format(
          "One solution through the {} has a crank and a coupler that are infinitely long.", pairs);
    case SliderCrankOutcome::linkage:
      break;
  }
  return {};
}

void check_length(std::vector<ConstraintCheck>& checks, const std::string& name, double length,
                  const std::optional<Range>& bounds) {
  if (!bounds) return;
  const double slack = kCheckTolerance * length;
  const bool inside = length >= bounds->min - slack && length <= bounds->max + slack;
  checks.push_back({"bounds." + name, length, *bounds, inside});
}

void check_defect(std::vector<ConstraintCheck>& checks, const char* name, bool wanted,
                  Defect defect, const Metrics& metrics) {
  if (!wanted) return;
  const bool none = std::ranges::count(metrics.defects, defect) == 0;
  checks.push_back({fmt::format("no_{}_defect", name), none ? std::string("none") : name,
                    std::string("none"), none});
}

/// What the file demands, checked on the finished mechanism. The start angle and the displacement
/// are within their bounds whole turns aside.
std::vector<ConstraintCheck> checks_of(const FunctionProblem& problem,
                                       const SliderGenerator& generator, const Metrics& metrics) {
  std::vector<ConstraintCheck> checks;
  const SliderCrank& m = generator.mechanism;
  check_length(checks, "crank", m.crank, problem.bounds.crank);
  check_length(checks, "coupler", m.coupler, problem.bounds.coupler);
  const double unit = std::max({m.crank, m.coupler, std::abs(m.offset)});
  if (const auto& given = problem.offset) {
    checks.push_back({"mechanism.offset", m.offset, *given,
                      std::abs(m.offset - *given) <= kCheckTolerance * unit});
  }
  if (const auto& bounds = problem.offset_bounds) {
    checks.push_back({"bounds.offset", m.offset, *bounds,
                      m.offset >= bounds->min - kCheckTolerance * unit &&
                          m.offset <= bounds->max + kCheckTolerance * unit});
  }
  if (const auto& limits = problem.constraints.transmission_angle) {
    const bool low =
        metrics.transmission_min - limits->min < limits->max - metrics.transmission_max;
    const double worst = low ? metrics.transmission_min : metrics.transmission_max;
    const bool inside = metrics.transmission_min >= limits->min - kCheckTolerance &&
                        metrics.transmission_max <= limits->max + kCheckTolerance;
    checks.push_back({"transmission_angle_deg", degrees(worst),
                      Range{degrees(limits->min), degrees(limits->max)}, inside});
  }
  if (const auto& most = problem.constraints.link_ratio_max) {
    const double ratio = std::max(m.crank, m.coupler) / std::min(m.crank, m.coupler);
    checks.push_back({"link_ratio_max", ratio, *most, ratio <= *most * (1 + kCheckTolerance)});
  }
  check_defect(checks, "circuit", problem.constraints.no_circuit_defect, Defect::circuit, metrics);
  check_defect(checks, "branch", problem.constraints.no_branch_defect, Defect::branch, metrics);
  check_defect(checks, "order", problem.constraints.no_order_defect, Defect::order, metrics);
  check_start_angle(checks, "input_start_deg", generator.input_start, problem.input_start,
                    problem.input_start_bounds);
  if (const auto& given = problem.output_start) {
    const double slack = kCheckTolerance * (m.crank + m.coupler);
    checks.push_back({"mechanism.output_start", generator.output_start, *given,
                      std::abs(generator.output_start - *given) <= slack});
  }
  if (const auto& bounds = problem.output_start_bounds) {
    const double slack = kCheckTolerance * (m.crank + m.coupler);
    checks.push_back({"bounds.output_start", generator.output_start, *bounds,
                      generator.output_start >= bounds->min - slack &&
                          generator.output_start <= bounds->max + slack});
  }
  return checks;
}

/// The error over the whole range, or where the mechanism does not close there that at the pairs,
/// each in its own assembly.
TargetError error_of(const SliderGenerator& generator, const FunctionSamples& wanted,
                     const std::vector<Assembly>& sides) {
  const TargetError error = displacement_error_over(generator, wanted);
  if (std::isfinite(error.sum_of_squares) && closes_over(generator, wanted.sweep)) return error;
  TargetError at_points;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    SliderGenerator own = generator;
    own.mechanism.assembly = sides[i];
    const auto& point = wanted.precision[i];
    const double off = displacement_error(own, {point.input, point.output[0]}).value_or(0);
    at_points.sum_of_squares += off * off;
    at_points.max = std::max(at_points.max, std::abs(off));
  }
  at_points.rms = std::sqrt(at_points.sum_of_squares / static_cast<double>(sides.size()));
  return at_points;
}

Design design_of(const FunctionProblem& problem, const FunctionSamples& wanted,
                 const SliderCrankFunction& solution) {
  SliderGenerator generator{
      {.crank = solution.crank, .coupler = solution.coupler, .offset = solution.offset},
      solution.input_start,
      solution.output_start};
  const auto sides = sides_of(generator, wanted.precision);
  generator.mechanism.assembly = prevailing_side(sides);
  Design design;
  design.mechanism = named(generator.mechanism);
  for (const auto& point : wanted.precision) {
    design.crank_angles.push_back(in_one_turn(generator.input_start + point.input));
  }
  design.error = error_of(generator, wanted, sides);
  design.metrics = slider_metrics(generator, wanted.sweep, sides);
  design.metrics.precision_residual = solution.residual;
  design.metrics.condition = solution.condition;
  design.constraints = checks_of(problem, generator, design.metrics);
  design.origin = fmt::format("exact:slider-crank-{}", condition_count(wanted.precision));
  return design;
}

}  // namespace

ExactDesigns exact_slider_cranks(const FunctionProblem& problem, const FunctionSamples& wanted,
                                 const GivenStart& start) {
  const auto found =
      problem.offset ? synthesis::slider_crank_functions(wanted.precision, start, *problem.offset)
                     : synthesis::slider_crank_functions(wanted.precision, start);
  ExactDesigns result;
  result.dependent = found.dependent;
  result.solutions = found.solutions.size();
  for (const SliderCrankFunction& solution : found.solutions) {
    if (solution.outcome != SliderCrankOutcome::linkage) {
      note_once(result.notes, why_no_mechanism(solution, conditions_in_words(wanted)));
      continue;
    }
    result.designs.push_back(design_of(problem, wanted, solution));
  }
  return result;
}

}  // namespace cognate::problems
