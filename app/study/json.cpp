#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>
#include <variant>

#include "app/documents/json_values.hpp"
#include "app/documents/version.hpp"
#include "app/study/summary.hpp"
#include "problems/study/names.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;

std::string_view end_name(StudyEnd end) {
  switch (end) {
    case StudyEnd::interrupted:
      return "interrupted";
    case StudyEnd::time_limit:
      return "time-limit";
    default:
      return "done";
  }
}

ordered_json cell_json(const problems::Cell& cell) {
  if (const auto* number = std::get_if<double>(&cell)) return *number;
  if (const auto* word = std::get_if<std::string>(&cell)) return *word;
  return nullptr;
}

ordered_json variable_json(const problems::Study& study, const problems::StudyVariable& variable) {
  ordered_json json = {{"key", variable.key}};
  if (variable.range) {
    json["range"] = to_json(*variable.range);
    json["sampling"] = problems::to_string(study.sampling);
    json["count"] = study.samples;
  } else {
    json["values"] = variable.values;
  }
  json["scale"] = variable.logarithmic ? "log" : "linear";
  return json;
}

ordered_json filter_json(const problems::StudyFilter& filter) {
  ordered_json json = {{"name", filter.name}};
  if (!filter.words.empty()) {
    json["words"] = filter.words;
    return json;
  }
  if (std::isfinite(filter.min)) json["min"] = filter.min;
  if (std::isfinite(filter.max)) json["max"] = filter.max;
  return json;
}

ordered_json row_json(const StudyRows& rows, std::size_t row) {
  ordered_json json = {{"id", rows.ids[row]}};
  const auto width = rows.columns.size();
  for (std::size_t i = 0; i < width; ++i) {
    json[rows.columns[i]] = cell_json(rows.cells[row * width + i]);
  }
  json["status"] = problems::to_string(rows.statuses[row]);
  return json;
}

ordered_json counts_json(const problems::Study& study, const StudyCounts& counts) {
  return {{"designs", problems::design_count(study)},
          {"evaluated", counts.evaluated},
          {"kept", counts.kept},
          {"filtered", counts.filtered},
          {"solved", counts.solved},
          {"infeasible", counts.infeasible},
          {"no_solution", counts.no_solution},
          {"invalid", counts.invalid}};
}

}  // namespace

ordered_json study_json(const problems::Study& study) {
  ordered_json variables = ordered_json::array();
  for (const auto& variable : study.variables) variables.push_back(variable_json(study, variable));
  ordered_json filters = ordered_json::array();
  for (const auto& filter : study.filters) filters.push_back(filter_json(filter));
  ordered_json objectives = ordered_json::array();
  for (const auto& objective : study.objectives) {
    objectives.push_back({{"name", objective.name}, {"greatest", objective.greatest}});
  }
  return {{"title", study.title},
          {"base", study.base},
          {"variables", variables},
          {"metrics", study.metrics},
          {"filters", filters},
          {"objectives", objectives},
          {"rows", study.keep_all ? "all" : "passed"}};
}

ordered_json study_document(const problems::Study& study, const StudySummary& summary) {
  ordered_json best = ordered_json::array();
  for (std::size_t row = 0; row < summary.best.ids.size(); ++row) {
    best.push_back(row_json(summary.best, row));
  }
  const double rate =
      summary.seconds > 0 ? static_cast<double>(summary.evaluated) / summary.seconds : 0.0;
  return {{"format", "cognate-study/1"},
          {"version", version()},
          {"seed", summary.seed},
          {"status", end_name(summary.end)},
          {"study", study_json(study)},
          {"counts", counts_json(study, summary.counts)},
          {"best", best},
          {"notes", summary.notes},
          {"work",
           {{"seconds", summary.seconds},
            {"threads", summary.threads},
            {"designs", summary.evaluated},
            {"designs_per_second", rate}}}};
}

}  // namespace cognate::app
