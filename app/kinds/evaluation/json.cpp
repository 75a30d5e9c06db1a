#include <cmath>
#include <nlohmann/json.hpp>
#include <variant>

#include "app/documents/json_values.hpp"
#include "app/documents/layers_json.hpp"
#include "app/documents/tolerance_json.hpp"
#include "app/export/parts/stacked_parts.hpp"
#include "app/kinds/evaluation/kind.hpp"
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
  add_quantities(table, result.quantities);
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
                    {"mechanism", mechanism_json(problems::named(cognate.linkage))},
                    {"crank_deg", degrees(cognate.crank_angle)}});
  }
  return list;
}

}  // namespace

ordered_json Kind<AnalysisProblem>::design_json(const AnalysisProblem& problem,
                                                const AnalysisResult& result,
                                                std::size_t /*index*/) {
  ordered_json table = {{"mechanism", mechanism_json(problem.mechanism)}};
  table[drive_slides(problem) ? "slide" : "crank_deg"] = values_json(result.columns.front().values);
  table["metrics"] = metrics_json(result);
  table["constraints"] = ordered_json::array();
  table["origin"] = "given";
  if (result.tolerance) table["tolerance"] = tolerance_json(*result.tolerance);
  if (result.layers) table["layers"] = layers_json(*result.layers, drive_slides(problem));
  return table;
}

ordered_json Kind<AnalysisProblem>::report_data(const AnalysisProblem& problem,
                                                const AnalysisResult& result) {
  ordered_json data = analysis_report_data(problem, result);
  if (!result.layers) return data;
  LinkageScene scene{.problem = problem, .layers = problem.layers};
  scene.problem.layers.reset();
  data["bill"] = bill_for_page(scene);
  return data;
}

void Kind<AnalysisProblem>::add_findings(ordered_json& document, const AnalysisProblem& problem,
                                         const AnalysisResult& result) {
  auto& table = document["analysis"];
  table = {{"columns", columns_json(result)}, {"landmarks", landmarks_json(problem, result)}};
  if (problem.output.cognates) table["cognates"] = cognates_json(result);
}

}  // namespace cognate::app
