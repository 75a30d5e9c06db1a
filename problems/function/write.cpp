/// A function problem written down, and checked by reading what was written.
#include "problems/function/problem.hpp"
#include "problems/function/write_target.hpp"
#include "problems/layers/read.hpp"
#include "problems/linkage/warnings.hpp"
#include "problems/linkage/write_linkage.hpp"
#include "problems/raster/read.hpp"
#include "problems/tolerance/read.hpp"

namespace cognate::problems {
namespace reading {
namespace {

bool is_slider(const FunctionProblem& problem) {
  return problem.type == MechanismType::slider_crank;
}

TableWriter written_target(const FunctionProblem& problem) {
  TableWriter table = function_target_writer(problem.target, problem.sample_at, is_slider(problem));
  if (problem.objective == FunctionObjective::exact) {
    table.set("precision_points", problem.precision_points);
  } else {
    table.set_name("objective", problem.objective);
  }
  if (!problem.at.empty()) table.set("at", problem.at);
  if (problem.spacing != PointSpacing::chebyshev) table.set_name("spacing", problem.spacing);
  if (!problem.multiplicity.empty()) table.set("multiplicity", problem.multiplicity);
  if (!problem.derivatives.empty()) table.set("derivatives", problem.derivatives);
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
  if (is_slider(problem)) {
    return table.set("output_start", problem.output_start).set("offset", problem.offset);
  }
  return table.set_deg("output_start_deg", problem.output_start);
}

TableWriter written_bounds(const FunctionProblem& problem) {
  TableWriter table = bounds_writer(problem.bounds);
  table.set_deg("input_start_deg", problem.input_start_bounds);
  if (is_slider(problem)) {
    return table.set("output_start", problem.output_start_bounds)
        .set("offset", problem.offset_bounds);
  }
  return table.set_deg("output_start_deg", problem.output_start_bounds);
}

}  // namespace
}  // namespace reading

reading::Written KindTraits<FunctionProblem>::written(const FunctionProblem& problem) {
  using namespace reading;
  Written all;
  TableWriter constraints = constraints_writer(problem.constraints);
  write_design_layers(problem.layers, constraints);
  all.document =
      document_writer(kWord, problem.title, problem.length_unit)
          .set("target", written_target(problem))
          .set("mechanism", written_mechanism(problem))
          .set("bounds", written_bounds(problem))
          .set("constraints", constraints)
          .append(operation_tables(problem.constraints, problem.solve, all.faults))
          .set("solve", solve_writer(problem.solve).set_name("best_by", problem.best_by))
          .set("warnings", warnings_writer(problem.warnings))
          .append(raster_table(problem.raster))
          .append(layers_table(problem.layers))
          .append(tolerance_table(problem.tolerances, problem.type == MechanismType::four_bar))
          .take();
  return all;
}

tl::expected<FunctionProblem, std::vector<std::string>> KindTraits<FunctionProblem>::checked(
    const FunctionProblem& problem) {
  using namespace reading;
  if (const auto* function = std::get_if<FunctionOfX>(&problem.target)) {
    if (auto fault = fault_of_function(*function)) return tl::unexpected(std::vector{*fault});
  }
  const auto read = read_back(problem);
  if (!read) return tl::unexpected(read.error());
  FunctionProblem complete = problem;
  if (complete.sample_at.empty()) complete.sample_at = read->sample_at;
  if (!complete.given.crank) complete.given.crank = read->given.crank;
  return complete;
}

}  // namespace cognate::problems
