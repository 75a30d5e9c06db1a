/// A function problem written down, and checked by reading what was written.
#include <fmt/core.h>

#include <cmath>
#include <utility>

#include "problems/function/problem.hpp"
#include "problems/function/read_goal.hpp"
#include "problems/function/read_target.hpp"
#include "problems/linkage/warnings.hpp"
#include "problems/linkage/write_linkage.hpp"
#include "problems/raster/read.hpp"
#include "problems/tolerance/read.hpp"

namespace cognate::problems {
namespace reading {
namespace {

using Pairs = std::vector<std::pair<double, double>>;

/// A function of the user's own stands in the document by so many of its values.
constexpr int kValuesOfOwn = 257;

bool is_slider(const FunctionProblem& problem) {
  return problem.type == MechanismType::slider_crank;
}

Pairs values_of_own(const FunctionOfX& function) {
  Pairs rows;
  const auto& [first, last] = function.domain;
  for (int i = 0; i < kValuesOfOwn; ++i) {
    const double share = static_cast<double>(i) / (kValuesOfOwn - 1);
    const double x = i + 1 == kValuesOfOwn ? last : first + share * (last - first);
    rows.emplace_back(x, function.y(x));
  }
  return rows;
}

/// `function.y` is there.
void write_values(const FunctionOfX& function, bool slider, TableWriter& table) {
  if (!function.text.empty()) {
    table.set("function", function.text);
  } else {
    table.set("table", function.table.empty() ? values_of_own(function) : function.table);
  }
  table.set("domain", function.domain).set_deg("input_range_deg", function.input_range);
  if (slider) {
    table.set("output_range", function.output_range);
  } else {
    table.set_deg("output_range_deg", function.output_range);
  }
  if (!function.input_range && !function.output_range) table.set("relation", "angles");
}

void write_values(const AnglePairs& pairs, bool slider, TableWriter& table) {
  Array rows;
  for (const auto& [input, output] : pairs) {
    rows.push_back(node(Array{node_deg(input), slider ? node(output) : node_deg(output)}));
  }
  table.set(slider ? "pairs" : "pairs_deg", rows);
}

TableWriter written_target(const FunctionProblem& problem) {
  TableWriter table;
  std::visit([&](const auto& values) { write_values(values, is_slider(problem), table); },
             problem.target);
  if (problem.objective == FunctionObjective::exact) {
    table.set("precision_points", problem.precision_points);
  } else {
    table.set_name("objective", problem.objective);
  }
  if (!problem.at.empty()) table.set("at", problem.at);
  if (problem.spacing != PointSpacing::chebyshev) table.set_name("spacing", problem.spacing);
  if (!problem.multiplicity.empty()) table.set("multiplicity", problem.multiplicity);
  if (!problem.derivatives.empty()) table.set("derivatives", problem.derivatives);
  if (!problem.sample_at.empty()) table.set("sample_at", problem.sample_at);
  const auto* function = std::get_if<FunctionOfX>(&problem.target);
  const bool own = function && function->text.empty() && function->table.empty();
  if (own && problem.sample_at.empty()) table.set("samples", kDefaultSamples);
  return table;
}

TableWriter written_mechanism(const FunctionProblem& problem) {
  TableWriter table = given_writer(problem.given, to_string(problem.type));
  const bool exact = problem.objective == FunctionObjective::exact;
  const bool given = problem.input_start && problem.output_start;
  // A start that an exact synthesis leaves free is said to be: three pairs alone have none.
  if (problem.start != FunctionStart::free || (exact && !given)) {
    table.set_name("start", problem.start);
  }
  table.set_deg("input_start_deg", problem.input_start);
  if (is_slider(problem)) return table.set("output_start", problem.output_start);
  return table.set_deg("output_start_deg", problem.output_start);
}

TableWriter written_bounds(const FunctionProblem& problem) {
  TableWriter table = bounds_writer(problem.bounds);
  table.set_deg("input_start_deg", problem.input_start_bounds);
  if (is_slider(problem)) return table.set("output_start", problem.output_start_bounds);
  return table.set_deg("output_start_deg", problem.output_start_bounds);
}

/// What is wrong with the function itself, whose values need not be those of the document.
std::optional<std::string> fault_of_function(const FunctionProblem& problem) {
  const auto* function = std::get_if<FunctionOfX>(&problem.target);
  if (!function) return std::nullopt;
  if (!function->y)
    return "target has no function y(x); expected one in addition to its text or table";
  const auto& [first, last] = function->domain;
  if (!kNumber.accepts(first) || !kNumber.accepts(last) || !(first < last)) {
    return "target.domain is no interval; expected [x0, x1] with x0 < x1";
  }
  if (function->table.empty()) {
    const auto fault = function_fault(*function);
    return fault ? std::optional("target.function " + *fault) : std::nullopt;
  }
  for (const auto& [x, given] : values_of_own(*function)) {
    if (std::isfinite(given)) continue;
    return fmt::format("target.table is {} at x = {}; expected finite values", given, x);
  }
  return std::nullopt;
}

}  // namespace
}  // namespace reading

reading::Written KindTraits<FunctionProblem>::written(const FunctionProblem& problem) {
  using namespace reading;
  Written all;
  all.document =
      document_writer(kWord, problem.title, problem.length_unit)
          .set("target", written_target(problem))
          .set("mechanism", written_mechanism(problem))
          .set("bounds", written_bounds(problem))
          .set("constraints", constraints_writer(problem.constraints))
          .append(operation_tables(problem.constraints, problem.solve, all.faults))
          .set("solve", solve_writer(problem.solve).set_name("best_by", problem.best_by))
          .set("warnings", warnings_writer(problem.warnings))
          .append(raster_table(problem.raster))
          .append(tolerance_table(problem.tolerances, problem.type == MechanismType::four_bar))
          .take();
  return all;
}

tl::expected<FunctionProblem, std::vector<std::string>> KindTraits<FunctionProblem>::checked(
    const FunctionProblem& problem) {
  using namespace reading;
  if (auto fault = fault_of_function(problem)) return tl::unexpected(std::vector{*fault});
  const auto read = read_back(problem);
  if (!read) return tl::unexpected(read.error());
  FunctionProblem complete = problem;
  if (complete.sample_at.empty()) complete.sample_at = read->sample_at;
  if (!complete.given.crank) complete.given.crank = read->given.crank;
  return complete;
}

}  // namespace cognate::problems
