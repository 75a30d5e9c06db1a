/// A function of a chain written down, and checked by reading what was written.
#include "problems/chain/write_design.hpp"
#include "problems/chain_function/problem.hpp"
#include "problems/function/write_target.hpp"
#include "problems/layers/read.hpp"
#include "problems/linkage/warnings.hpp"
#include "problems/linkage/write_linkage.hpp"
#include "problems/tolerance/read.hpp"

namespace cognate::problems {
namespace reading {
namespace {

TableWriter target_writer(const ChainFunctionProblem& problem) {
  TableWriter table = function_target_writer(problem.target, problem.sample_at, slides(problem));
  table.set_name("objective", problem.objective);
  if (slides(problem)) return std::move(table).set("output", problem.output[1]);
  return std::move(table).set("output", problem.output);
}

TableWriter limits_writer(const ChainFunctionProblem& problem) {
  const auto& limits = problem.constraints;
  TableWriter table;
  table.set_deg("transmission_angle_deg", limits.transmission_angle).set_name("over", limits.over);
  if (limits.error) {
    const auto& [of, max] = *limits.error;
    is_angle(of) ? table.set_deg(to_string(of), max) : table.set(to_string(of), max);
  }
  write_design_layers(problem.layers, table);
  return table;
}

}  // namespace
}  // namespace reading

reading::Written KindTraits<ChainFunctionProblem>::written(const ChainFunctionProblem& problem) {
  using namespace reading;
  Written all;
  check_structure(problem.mechanism, problem.topologies, function_topologies(problem.mechanism),
                  all.faults);
  check_one_demand(problem.topologies, all.faults);
  all.document =
      document_writer(kWord, problem.title, problem.length_unit)
          .set("target", target_writer(problem))
          .set("mechanism", chain_mechanism_writer(problem.mechanism, problem.topologies))
          .set("bounds", chain_bounds_writer(problem.topologies))
          .set("constraints", limits_writer(problem))
          .set("solve", chain_solve_writer(problem.solve, problem.against))
          .set("warnings", warnings_writer(problem.warnings))
          .append(layers_table(problem.layers))
          .append(tolerance_table(problem.tolerances, !slides(problem)))
          .take();
  return all;
}

tl::expected<ChainFunctionProblem, std::vector<std::string>>
KindTraits<ChainFunctionProblem>::checked(const ChainFunctionProblem& problem) {
  using namespace reading;
  if (const auto* function = std::get_if<FunctionOfX>(&problem.target)) {
    if (auto fault = fault_of_function(*function)) return tl::unexpected(std::vector{*fault});
  }
  ChainFunctionProblem complete = problem;
  if (complete.topologies.empty()) complete.topologies = function_topologies(complete.mechanism);
  const auto read = read_back(complete);
  if (!read) return tl::unexpected(read.error());
  complete.topologies = read->topologies;
  if (complete.sample_at.empty()) complete.sample_at = read->sample_at;
  return complete;
}

}  // namespace cognate::problems
