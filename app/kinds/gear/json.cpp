#include "app/kinds/gear/json.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/documents/json_values.hpp"
#include "app/documents/problem_json.hpp"
#include "app/documents/result_json.hpp"
#include "app/documents/version.hpp"
#include "problems/basics/names.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;
using problems::Fact;
using problems::GearPairDesign;
using problems::GearPairProblem;
using problems::GearPairResult;
using problems::GearProblem;
using problems::GearResult;
using problems::to_string;

bool is_true(const std::vector<Fact>& facts, std::string_view name) {
  return std::ranges::any_of(facts, [&](const Fact& fact) {
    const auto* answer = std::get_if<bool>(&fact.value);
    return fact.name == name && answer != nullptr && *answer;
  });
}

std::optional<double> number(const std::vector<Fact>& facts, std::string_view name) {
  const auto found = std::ranges::find(facts, name, &Fact::name);
  const auto* value = found == facts.end() ? nullptr : std::get_if<double>(&found->value);
  return value && std::isfinite(*value) ? std::optional(*value) : std::nullopt;
}

bool is_below(const std::vector<Fact>& facts, std::string_view name, double least) {
  const auto value = number(facts, name);
  return value && *value < least;
}

/// What is wrong with the gear whose facts begin with `prefix`.
void add_defects(const std::vector<Fact>& facts, const std::string& prefix, ordered_json& defects) {
  const auto add = [&](const char* defect, bool has) {
    if (has && std::ranges::find(defects, defect) == defects.end()) defects.push_back(defect);
  };
  add("undercut", is_true(facts, prefix + "undercut"));
  add("pointed", is_below(facts, prefix + "tip_thickness", 0));
  add("interference", is_true(facts, prefix + "interferes"));
}

/// 90° less the working pressure angle: between the line of action and the motion of the contact.
ordered_json transmission_json(const std::vector<Fact>& facts) {
  const auto pressure = number(facts, "working_pressure_angle_deg");
  if (!pressure) return nullptr;
  const double angle = 90 - *pressure;
  return {{"min", angle}, {"max", angle}, {"acute_min", angle}};
}

ordered_json metrics_json(problems::Gearing gearing, const std::vector<Fact>& facts) {
  ordered_json table = {{"class", to_string(gearing)}};
  add_finite_facts(table, facts);
  table["transmission_angle_deg"] = transmission_json(facts);
  table["time_ratio"] = nullptr;
  ordered_json defects = ordered_json::array();
  for (const char* prefix : {"", "pinion.", "wheel."}) add_defects(facts, prefix, defects);
  const char* ratio =
      number(facts, "total_contact_ratio") ? "total_contact_ratio" : "contact_ratio";
  if (is_below(facts, ratio, 1 - 1e-9)) defects.push_back("contact-ratio");
  table["defects"] = defects;
  return table;
}

ordered_json design_json(ordered_json mechanism, ordered_json metrics,
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

ordered_json design_json(const GearPairDesign& design) {
  return design_json(mechanism_json(design), metrics_json(design.settled.gearing, design.metrics),
                     design.constraints, design.origin);
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

template <class Problem, class Result>
ordered_json document_head(const Problem& problem, const Result& result, std::uint64_t seed) {
  return {{"format", "cognate-result/1"},
          {"version", version()},
          {"seed", seed},
          {"status", to_string(result.status)},
          {"problem", to_json(problem)},
          {"designs", ordered_json::array()}};
}

template <class Result>
tl::expected<ordered_json, std::string> finished(ordered_json document, const Result& result) {
  document["notes"] = result.notes;
  document["work"] = to_json(result.work);
  if (const auto where = find_non_finite(document)) {
    return tl::unexpected(fmt::format("the result has no finite number at {}", *where));
  }
  return document;
}

}  // namespace

ordered_json mechanism_json(const GearProblem& problem) {
  const ordered_json tables = to_json(problem);
  ordered_json mechanism = {{"type", "gear"}};
  mechanism.update(tables["mechanism"]);
  mechanism["rack"] = tables["rack"];
  return mechanism;
}

ordered_json mechanism_json(const GearPairDesign& design) {
  const ordered_json tables = to_json(design.settled);
  ordered_json mechanism = {{"type", "gear-pair"}};
  mechanism.update(tables["mechanism"]);
  // Bevel gears have none; that of a worm and a wheel that cannot be may lie beyond the axes.
  const bool has_distance = design.settled.gearing != problems::Gearing::bevel;
  if (has_distance && design.settled.centre_distance.value_or(0) > 0) {
    mechanism["centre_distance"] = *design.settled.centre_distance;
  }
  mechanism["rack"] = tables["rack"];
  return mechanism;
}

ordered_json best_design_json(const GearProblem& problem, const GearResult& result) {
  return design_json(mechanism_json(problem), metrics_json(problem.gearing, result.metrics), {},
                     "given");
}

ordered_json best_design_json(const GearPairProblem& /*problem*/, const GearPairResult& result) {
  if (result.designs.empty()) return ordered_json::object();
  ordered_json design = design_json(result.designs.front());
  add_finite_facts(design["facts"], result.facts);
  return design;
}

tl::expected<ordered_json, std::string> result_document(const GearProblem& problem,
                                                        const GearResult& result,
                                                        std::uint64_t seed) {
  ordered_json document = document_head(problem, result, seed);
  document["designs"].push_back(best_design_json(problem, result));
  document["gear"] = {{"columns", columns_json(result)}};
  return finished(std::move(document), result);
}

tl::expected<ordered_json, std::string> result_document(const GearPairProblem& problem,
                                                        const GearPairResult& result,
                                                        std::uint64_t seed) {
  ordered_json document = document_head(problem, result, seed);
  for (const auto& design : result.designs) document["designs"].push_back(design_json(design));
  if (!result.facts.empty()) {
    document["facts"] = ordered_json::object();
    add_finite_facts(document["facts"], result.facts);
  }
  return finished(std::move(document), result);
}

}  // namespace cognate::app
