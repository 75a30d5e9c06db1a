#include "app/documents/problem_tables.hpp"

#include "app/documents/cycle_tables.hpp"
#include "problems/basics/names.hpp"
#include "problems/linkage/error_limit.hpp"
#include "problems/linkage/linkage_keys.hpp"

namespace cognate::app {

using nlohmann::ordered_json;
using problems::to_string;

void set(ordered_json& table, std::string_view key, const std::optional<double>& value) {
  if (value) table[std::string(key)] = *value;
}

void set_deg(ordered_json& table, std::string_view key, const std::optional<double>& value) {
  if (value) table[std::string(key)] = degrees(*value);
}

void set_deg(ordered_json& table, std::string_view key,
             const std::optional<problems::Range>& value) {
  if (value) table[std::string(key)] = to_json_deg(*value);
}

ordered_json mechanism_table(const problems::Given& given) {
  ordered_json table = {{"type", "four-bar"}};
  for (const auto& link : problems::kLinkKeys) set(table, link.key, given.*link.given);
  set_deg(table, "frame_angle_deg", given.frame_angle);
  for (const auto& place : problems::kPlaceKeys) set_json(table, place.key, given.*place.given);
  if (given.assembly) table["assembly"] = to_string(*given.assembly);
  return table;
}

ordered_json bounds_table(const problems::Bounds& given) {
  ordered_json table = ordered_json::object();
  for (const auto& link : problems::kLinkKeys) set_json(table, link.key, given.*link.bounds);
  set_deg(table, "frame_angle_deg", given.frame_angle);
  for (const auto& place : problems::kPlaceKeys) set_json(table, place.key, given.*place.bounds);
  return table;
}

ordered_json constraints_table(const problems::Constraints& given) {
  ordered_json table = ordered_json::object();
  if (given.required_class) table["class"] = to_string(*given.required_class);
  set_deg(table, "transmission_angle_deg", given.transmission_angle);
  set(table, "link_ratio_max", given.link_ratio_max);
  set_json(table, "time_ratio", given.time_ratio);
  set_json(table, "pivot_region", given.pivot_region);
  add_cycle_limits(given, table);
  if (given.error) {
    const auto& [of, most] = *given.error;
    table[std::string(to_string(of))] = problems::shown_error(of, most);
  }
  table["no_branch_defect"] = given.no_branch_defect;
  table["no_order_defect"] = given.no_order_defect;
  table["no_circuit_defect"] = given.no_circuit_defect;
  return table;
}

ordered_json solve_table(const problems::Solve& given) {
  ordered_json table = {{"solver", to_string(given.solver)}};
  if (given.starts) table["starts"] = *given.starts;
  table["designs"] = given.designs;
  for (const auto measure : given.objectives) table["objectives"].push_back(to_string(measure));
  if (given.loss != synthesis::Loss::none) {
    table["loss"] = to_string(given.loss);
    table["loss_scale"] = given.loss_scale;
  }
  set(table, "tolerance", given.tolerance);
  if (given.certify) {
    table["certify"] = true;
    table["certify_gap"] = given.certify_gap;
  }
  return table;
}

ordered_json document(const char* kind, const std::string& title) {
  ordered_json tables = {{"kind", kind}};
  if (!title.empty()) tables["title"] = title;
  return tables;
}

}  // namespace cognate::app
