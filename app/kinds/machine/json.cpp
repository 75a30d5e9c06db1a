#include "app/kinds/machine/json.hpp"

#include <fmt/core.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/documents/json_values.hpp"
#include "app/documents/result_json.hpp"
#include "app/documents/version.hpp"
#include "problems/basics/names.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;
using problems::MachineProblem;
using problems::MachineResult;

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

ordered_json design_json(const MachineProblem& problem, const MachineResult& result) {
  ordered_json metrics = ordered_json::object();
  add_finite_facts(metrics, result.facts);
  return {{"mechanism", machine_mechanism_json(problem)},
          {"crank_deg", ordered_json::array()},
          {"metrics", metrics},
          {"constraints", ordered_json::array()},
          {"origin", "given"}};
}

}  // namespace

tl::expected<ordered_json, std::string> result_document(const MachineProblem& problem,
                                                        const MachineResult& result,
                                                        std::uint64_t seed) {
  ordered_json document = {{"format", "cognate-result/1"},
                           {"version", version()},
                           {"seed", seed},
                           {"status", problems::to_string(result.status)},
                           {"problem", to_json(problem)},
                           {"designs", ordered_json::array({design_json(problem, result)})},
                           {"machine", {{"motions", motions_json(result)}}},
                           {"notes", result.notes},
                           {"work", to_json(result.work)}};
  if (const auto where = find_non_finite(document)) {
    return tl::unexpected(fmt::format("the result has no finite number at {}", *where));
  }
  return document;
}

}  // namespace cognate::app
