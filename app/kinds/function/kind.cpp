#include "app/kinds/function/kind.hpp"

#include <fmt/core.h>

#include "analysis/numbers/constants.hpp"
#include "app/console/messages.hpp"
#include "app/console/table_text.hpp"
#include "app/report/function_trace.hpp"
#include "problems/basics/names.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;
using problems::FunctionProblem;

constexpr Entry kFunction[] = {
    {"target.function", "an expression in x, as \"log10(x)\""},
    {"target.domain", "[x0, x1] of the function"},
    {"target.table",
     "or: [[x, y], ...]; between the rows a cubic that rises and falls only where the rows do"},
    {"target.pairs_deg", "or: [[input, output], ...]"},
    {"target.pairs", "of a slider-crank: [[input_deg, displacement], ...]"},
    {"target.input_range_deg", "the input's sweep for the domain"},
    {"target.output_range_deg", "the output's sweep for the values (negative: the other sense)"},
    {"target.output_range", "of a slider-crank: the slider's travel"},
    {"target.relation", "\"angles\": x and y are the angles themselves, in radians"},
    {"target.precision_points", "3, 4 or 5: exact synthesis"},
    {"target.at", "the precision points' x (default: by spacing)"},
    {"target.multiplicity", "how often each of at counts: 2 takes the first derivative too, ..."},
    {"target.derivatives", "of pairs: [[first, second, ...], ...] to be met at each"},
    {"target.spacing", "\"chebyshev\" (default), or \"equal-peaks\": a minimax generator"},
    {"target.objective", "\"least-squares\" (default), \"minimax\" or \"exact\""},
    {"target.method", "\"exact\": exact synthesis, of pairs"},
    {"target.samples", "how many samples the error is taken at (default 61)"},
    {"target.sample_at", "or: their x"},
    {"mechanism.type", "\"four-bar\" (default) or, exactly, \"slider-crank\""},
    {"mechanism.crank", "its length (default 1); coupler, rocker, frame: likewise, or free"},
    {"mechanism.input_start_deg", "input angle at the start, from A to D; free by default"},
    {"mechanism.output_start_deg", "output angle at the start; free by default"},
    {"mechanism.output_start", "of a slider-crank: displacement at the start"},
    {"mechanism.offset", "of a slider-crank: of its slide line; free by default"},
    {"bounds.offset", "of a slider-crank: [min, max]"},
    {"mechanism.start",
     "\"free\" (default), \"outer-dead-centre\" or \"inner-dead-centre\" of the output"},
    {"solve.best_by", "order of exact designs: \"transmission\" or \"error\""}};

ordered_json pairs_json(const std::vector<synthesis::AnglePair>& pairs) {
  ordered_json list = ordered_json::array();
  for (const auto& pair : pairs) list.push_back(ordered_json::array({pair.input, pair.output}));
  return list;
}

}  // namespace

std::span<const Entry> Kind<FunctionProblem>::keys() {
  return kFunction;
}

std::string Kind<FunctionProblem>::describe(const FunctionProblem& problem) {
  if (const auto* pairs = std::get_if<problems::AnglePairs>(&problem.target)) {
    const bool slider = problem.type == problems::MechanismType::slider_crank;
    return titled(problem.title, fmt::format("function generation, {} pairs of angles{}",
                                             pairs->size(), slider ? " and displacements" : ""));
  }
  const auto& function = std::get<problems::FunctionOfX>(problem.target);
  const auto what = function.text.empty()
                        ? fmt::format("a table of {} points", function.table.size())
                        : "y = " + function.text;
  const auto aim =
      problem.objective == problems::FunctionObjective::exact
          ? counted(static_cast<std::size_t>(problem.precision_points), "precision point")
          : counted(problem.sample_at.size(), "sample");
  return titled(problem.title, fmt::format("function generation, {}, {}", what, aim));
}

ColumnChoice Kind<FunctionProblem>::columns(const FunctionProblem& problem) {
  const bool angles = problem.type == problems::MechanismType::four_bar;
  return {.error_unit = angles ? "deg" : "length",
          .angular_output = true,
          .quantities = kObjectiveQuantities};
}

/// What a function generator is to do, for whoever evaluates another design: increments of both
/// angles in radians where the error counts and over the domain, the ends of the motion, and those
/// of x (null for pairs).
ordered_json Kind<problems::FunctionProblem>::target_json(
    const problems::FunctionProblem& problem) {
  if (problem.type != problems::MechanismType::four_bar) return {{"kind", "function"}};
  const auto wanted = problems::function_samples(problem);
  const auto* function = std::get_if<problems::FunctionOfX>(&problem.target);
  ordered_json x;
  if (function) x = {function->domain.min, function->domain.max};
  return {{"kind", "function"},
          {"samples", pairs_json(wanted.samples)},
          {"range", pairs_json(wanted.range)},
          {"sweep", {wanted.sweep.min, wanted.sweep.max}},
          {"x", x}};
}

ordered_json Kind<problems::FunctionProblem>::reached_json(const problems::FunctionProblem& problem,
                                                           const problems::Design& design) {
  const auto wanted = problems::function_samples(problem);
  const bool slides = problem.type == problems::MechanismType::slider_crank;
  return {{"trace", trace_json(function_trace(problem, wanted, design), slides)}};
}

}  // namespace cognate::app
