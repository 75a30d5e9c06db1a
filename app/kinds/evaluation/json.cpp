#include "app/kinds/evaluation/json.hpp"

#include <fmt/core.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <variant>

#include "app/documents/json_values.hpp"
#include "app/documents/result_json.hpp"
#include "app/documents/version.hpp"
#include "app/kinds/evaluation/problem_json.hpp"
#include "problems/basics/names.hpp"
#include "problems/evaluation/output_travel.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;
using problems::AnalysisProblem;
using problems::AnalysisResult;
using problems::drive_slides;

ordered_json metrics_json(const AnalysisResult& result) {
  ordered_json table = ordered_json::object();
  add_facts(table, result.facts);
  for (const char* always : {"transmission_angle_deg", "time_ratio"}) {
    if (!table.contains(always)) table[always] = nullptr;
  }
  table["defects"] = ordered_json::array();
  return table;
}

ordered_json values_json(const std::vector<double>& values) {
  ordered_json list = ordered_json::array();
  for (const double value : values) {
    list.push_back(std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr));
  }
  return list;
}

ordered_json design_json(const AnalysisProblem& problem, const AnalysisResult& result) {
  ordered_json table = {{"mechanism", mechanism_json(problem.mechanism)}};
  table[drive_slides(problem) ? "slide" : "crank_deg"] = values_json(result.columns.front().values);
  table["metrics"] = metrics_json(result);
  table["constraints"] = ordered_json::array();
  table["origin"] = "given";
  return table;
}

ordered_json columns_json(const AnalysisResult& result) {
  ordered_json list = ordered_json::array();
  for (const auto& column : result.columns) {
    list.push_back({{"name", column.name},
                    {"quantity", column.quantity},
                    {"of", column.of},
                    {"unit", column.unit},
                    {"values", values_json(column.values)}});
  }
  return list;
}

/// A coordinate of a body: an angle under a key that ends in _deg, or a length.
void set_coordinate(ordered_json& table, const std::string& key, double value, bool angle) {
  table[angle ? key + "_deg" : key] = angle ? degrees(value) : value;
}

ordered_json landmarks_json(const AnalysisProblem& problem, const AnalysisResult& result) {
  const bool output_turns = !problems::output_travel(problem.mechanism).slides;
  ordered_json list = ordered_json::array();
  for (const auto& landmark : result.landmarks) {
    ordered_json entry = {{"kind", landmark.kind}, {"of", landmark.of}};
    set_coordinate(entry, drive_slides(problem) ? "slide" : "crank", landmark.drive,
                   !drive_slides(problem));
    if (std::isfinite(landmark.value)) {
      set_coordinate(entry, "output", landmark.value, output_turns);
    }
    if (landmark.again) {
      set_coordinate(entry, drive_slides(problem) ? "again_slide" : "again_crank", *landmark.again,
                     !drive_slides(problem));
    }
    list.push_back(entry);
  }
  return list;
}

/// Each as `[mechanism]` tables, with its crank's angle where the drive starts.
ordered_json cognates_json(const AnalysisResult& result) {
  ordered_json list = ordered_json::array();
  for (const problems::Cognate& cognate : result.cognates) {
    list.push_back({{"crank_turns_with", cognate.timed ? "crank" : "coupler"},
                    {"mechanism", to_json(cognate.linkage)},
                    {"crank_deg", degrees(cognate.crank_angle)}});
  }
  return list;
}

ordered_json analysis_json(const AnalysisProblem& problem, const AnalysisResult& result) {
  ordered_json table = {{"columns", columns_json(result)},
                        {"landmarks", landmarks_json(problem, result)}};
  if (problem.output.cognates) table["cognates"] = cognates_json(result);
  return table;
}

}  // namespace

tl::expected<ordered_json, std::string> result_document(const AnalysisProblem& problem,
                                                        const AnalysisResult& result,
                                                        std::uint64_t seed) {
  ordered_json document = {{"format", "cognate-result/1"},
                           {"version", version()},
                           {"seed", seed},
                           {"status", problems::to_string(result.status)},
                           {"problem", to_json(problem)},
                           {"designs", ordered_json::array({design_json(problem, result)})},
                           {"analysis", analysis_json(problem, result)},
                           {"notes", result.notes},
                           {"work", to_json(result.work)}};
  if (const auto where = find_non_finite(document)) {
    return tl::unexpected(fmt::format("the result has no finite number at {}", *where));
  }
  return document;
}

}  // namespace cognate::app
