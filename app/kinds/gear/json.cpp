#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/documents/json_values.hpp"
#include "app/kinds/gear/kind.hpp"
#include "problems/basics/names.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;
using problems::GearPairDesign;
using problems::GearPairProblem;
using problems::GearPairResult;
using problems::GearProblem;
using problems::GearResult;
using problems::Quantity;
using problems::to_string;

bool is_true(const std::vector<Quantity>& quantities, std::string_view name) {
  return std::ranges::any_of(quantities, [&](const Quantity& quantity) {
    const auto* answer = std::get_if<bool>(&quantity.value);
    return quantity.name == name && answer != nullptr && *answer;
  });
}

std::optional<double> number(const std::vector<Quantity>& quantities, std::string_view name) {
  const auto found = std::ranges::find(quantities, name, &Quantity::name);
  const auto* value = found == quantities.end() ? nullptr : std::get_if<double>(&found->value);
  return value && std::isfinite(*value) ? std::optional(*value) : std::nullopt;
}

bool is_below(const std::vector<Quantity>& quantities, std::string_view name, double least) {
  const auto value = number(quantities, name);
  return value && *value < least;
}

/// What is wrong with the gear whose quantities begin with `prefix`.
void add_defects(const std::vector<Quantity>& quantities, const std::string& prefix,
                 ordered_json& defects) {
  const auto add = [&](const char* defect, bool has) {
    if (has && std::ranges::find(defects, defect) == defects.end()) defects.push_back(defect);
  };
  add("undercut", is_true(quantities, prefix + "undercut"));
  add("pointed", is_below(quantities, prefix + "tip_thickness", 0));
  add("interference", is_true(quantities, prefix + "interferes"));
}

/// 90° less the working pressure angle: between the line of action and the motion of the contact.
ordered_json transmission_json(const std::vector<Quantity>& quantities) {
  const auto pressure = number(quantities, "working_pressure_angle_deg");
  if (!pressure) return nullptr;
  const double angle = 90 - *pressure;
  return {{"min", angle}, {"max", angle}, {"acute_min", angle}};
}

ordered_json metrics_json(problems::Gearing gearing, const std::vector<Quantity>& quantities) {
  ordered_json table = {{"class", to_string(gearing)}};
  add_finite_quantities(table, quantities);
  table["transmission_angle_deg"] = transmission_json(quantities);
  table["time_ratio"] = nullptr;
  ordered_json defects = ordered_json::array();
  for (const char* prefix : {"", "pinion.", "wheel."}) add_defects(quantities, prefix, defects);
  const char* ratio =
      number(quantities, "total_contact_ratio") ? "total_contact_ratio" : "contact_ratio";
  if (is_below(quantities, ratio, 1 - 1e-9)) defects.push_back("contact-ratio");
  table["defects"] = defects;
  return table;
}

ordered_json gear_design_json(ordered_json mechanism, ordered_json metrics,
                              const std::vector<problems::ConstraintCheck>& checks,
                              const std::string& origin) {
  ordered_json table = {{"mechanism", std::move(mechanism)},
                        {"crank_deg", ordered_json::array()},
                        {"error", {{"sum_of_squares", 0.0}, {"rms", 0.0}, {"max", 0.0}}},
                        {"metrics", std::move(metrics)},
                        {"constraints", ordered_json::array()}};
  for (const auto& check : checks) table["constraints"].push_back(to_json(check));
  table["origin"] = origin;
  return table;
}

ordered_json pair_mechanism_json(const GearProblem& problem) {
  const ordered_json tables = problem_json(problem);
  ordered_json mechanism = {{"type", "gear"}};
  mechanism.update(tables["mechanism"]);
  mechanism["rack"] = tables["rack"];
  return mechanism;
}

ordered_json pair_mechanism_json(const GearPairDesign& design) {
  const ordered_json tables = problem_json(design.settled);
  ordered_json mechanism = {{"type", "gear-pair"}};
  mechanism.update(tables["mechanism"]);
  // Bevel gears and racks have none; that of a worm and a wheel that cannot be may lie beyond the
  // axes.
  const auto gearing = design.settled.gearing;
  const bool has_distance =
      gearing != problems::Gearing::bevel && gearing != problems::Gearing::rack;
  if (has_distance && design.settled.centre_distance.value_or(0) > 0) {
    mechanism["centre_distance"] = *design.settled.centre_distance;
  }
  mechanism["rack"] = tables["rack"];
  return mechanism;
}

ordered_json columns_json(const GearResult& result) {
  ordered_json list = ordered_json::array();
  for (const auto& column : result.columns) {
    ordered_json values = ordered_json::array();
    for (const double value : column.values) {
      values.push_back(std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr));
    }
    list.push_back({{"name", column.name}, {"unit", column.unit}, {"values", values}});
  }
  return list;
}

}  // namespace

ordered_json Kind<GearProblem>::design_json(const GearProblem& problem, const GearResult& result,
                                            std::size_t /*index*/) {
  return gear_design_json(pair_mechanism_json(problem),
                          metrics_json(problem.gearing, result.metrics), {}, "given");
}

void Kind<GearProblem>::add_findings(ordered_json& document, const GearProblem& /*problem*/,
                                     const GearResult& result) {
  document["gear"] = {{"columns", columns_json(result)}};
}

ordered_json Kind<GearPairProblem>::design_json(const GearPairProblem& /*problem*/,
                                                const GearPairResult& result, std::size_t index) {
  const GearPairDesign& design = result.designs[index];
  return gear_design_json(pair_mechanism_json(design),
                          metrics_json(design.settled.gearing, design.metrics), design.constraints,
                          design.origin);
}

void Kind<GearPairProblem>::add_facts(ordered_json& table, const GearPairResult& result) {
  if (result.quantities.empty()) return;
  table["facts"] = ordered_json::object();
  add_finite_quantities(table["facts"], result.quantities);
}

ExportOutcome Kind<GearProblem>::export_design(const ResultDesign& design,
                                               const ExportOptions& wanted,
                                               const std::string& stem) {
  return exported(result_gears(design),
                  [&](const ResultGears& gears) { return export_gears(gears, wanted, stem); });
}

ExportOutcome Kind<GearPairProblem>::export_design(const ResultDesign& design,
                                                   const ExportOptions& wanted,
                                                   const std::string& stem) {
  return Kind<GearProblem>::export_design(design, wanted, stem);
}

}  // namespace cognate::app
