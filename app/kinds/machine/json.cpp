#include <cmath>
#include <nlohmann/json.hpp>

#include "app/kinds/machine/kind.hpp"
#include "app/study/design_values.hpp"
#include "app/study/metrics.hpp"
#include "problems/basics/names.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;
using problems::MachineProblem;
using problems::MachineResult;

/// What is written as the mechanism of the one design.
ordered_json machine_mechanism_json(const MachineProblem& problem) {
  const ordered_json tables = problem_json(problem);
  if (problem.mechanism) return tables["mechanism"];
  ordered_json table = {{"type", "equivalent"}};
  table.update(tables.value("equivalent", ordered_json::object()));
  return table;
}

ordered_json column_json(const problems::Column& column) {
  ordered_json values = ordered_json::array();
  for (const double value : column.values) {
    values.push_back(std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr));
  }
  return {{"name", column.name},
          {"quantity", column.quantity},
          {"of", column.of},
          {"unit", column.unit},
          {"values", values}};
}

ordered_json motions_json(const MachineResult& result) {
  ordered_json list = ordered_json::array();
  for (const problems::MachineMotion& motion : result.motions) {
    ordered_json columns = ordered_json::array();
    for (const auto& column : motion.columns) columns.push_back(column_json(column));
    list.push_back({{"task", problems::to_string(motion.task)}, {"columns", columns}});
  }
  return list;
}

}  // namespace

ordered_json Kind<MachineProblem>::design_json(const MachineProblem& problem,
                                               const MachineResult& result, std::size_t /*index*/) {
  ordered_json metrics = ordered_json::object();
  add_finite_quantities(metrics, result.quantities);
  return {{"mechanism", machine_mechanism_json(problem)},
          {"crank_deg", ordered_json::array()},
          {"metrics", metrics},
          {"constraints", ordered_json::array()},
          {"origin", "given"}};
}

void Kind<MachineProblem>::add_findings(ordered_json& document, const MachineProblem& /*problem*/,
                                        const MachineResult& result) {
  document["machine"] = {{"motions", motions_json(result)}};
}

problems::MetricNames Kind<MachineProblem>::metric_names(const MachineProblem& base) {
  problems::MetricNames names;
  add_metrics(names, metric_lists().front().metrics);
  add_values(names.names, machine_mechanism_json(base), "mechanism");
  return names;
}

ExportOutcome Kind<MachineProblem>::export_design(const ResultDesign& design,
                                                  const ExportOptions& /*wanted*/,
                                                  const std::string& /*stem*/) {
  return tl::unexpected(ExportRefusal{
      design.name +
          ": designs[0]: mechanism.type is \"equivalent\", a machine given by its inertia and "
          "torque, which has no shape; expected one with a [mechanism]",
      true});
}

}  // namespace cognate::app
