#include "app/report/analysis_report_data.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <span>

#include "analysis/numbers/constants.hpp"
#include "app/report/column_vectors.hpp"
#include "app/report/drawn_number.hpp"
#include "app/report/drawn_rows.hpp"
#include "app/report/load_arrows.hpp"
#include "app/report/mechanism_json.hpp"
#include "app/report/quantity_json.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;
using problems::AnalysisProblem;
using problems::AnalysisResult;

/// Rows and values of the table that a page holds at most: curves are some hundred pixels wide, and
/// a value takes about ten characters.
constexpr std::size_t kAnalysisRows = 721, kAnalysisCells = 28'000;

/// Whether the last position of the drive is the first one again.
bool comes_round(const AnalysisProblem& problem) {
  if (driven_by_length(problem.mechanism.mechanism.drive)) return false;
  const double turns = (problem.drive.end - problem.drive.start) / (kTurn);
  return std::abs(turns) > 0.5 && std::abs(turns - std::round(turns)) < 1e-9;
}

ordered_json moved_drive(const AnalysisProblem& problem) {
  const auto& drive = problem.drive;
  ordered_json table =
      drive_json(problem.mechanism, {drive.start, drive.end, comes_round(problem)});
  table["speed"] = drive_unit(problem.mechanism) * drive.rate.speed;
  return table;
}

/// The rows' drive coordinates, and each column's values in them.
ordered_json table_json(const AnalysisProblem& problem, const AnalysisResult& result,
                        std::span<const std::size_t> rows) {
  const double unit = drive_unit(problem.mechanism);
  const double steps = std::max(1, problem.drive.steps);
  ordered_json drive = ordered_json::array(), columns = ordered_json::array();
  for (const std::size_t row : rows) {
    const double share = static_cast<double>(row) / steps;
    drive.push_back(unit * std::lerp(problem.drive.start, problem.drive.end, share));
  }
  for (const problems::Column& column : result.columns) {
    ordered_json values = ordered_json::array();
    for (const std::size_t row : rows) values.push_back(drawn(column.values.at(row)));
    columns.push_back({{"name", column.name},
                       {"quantity", column.quantity},
                       {"of", column.of},
                       {"unit", column.unit},
                       {"values", values}});
  }
  const std::size_t all = result.columns.empty() ? 0 : result.columns.front().values.size();
  return {{"rows", all}, {"drive", drive}, {"columns", columns}};
}

ordered_json vectors_json(const AnalysisProblem& problem, const AnalysisResult& result) {
  ordered_json list = ordered_json::array();
  for (const auto& vector : column_vectors(problem.mechanism, result.columns)) {
    ordered_json entry = {{"x", vector.x}, {"y", vector.y}, {"body", nullptr}, {"at", nullptr}};
    if (vector.at) {
      entry["body"] = vector.at->body;
      entry["at"] = {drawn(vector.at->at.x), drawn(vector.at->at.y)};
    }
    list.push_back(entry);
  }
  return list;
}

ordered_json normals_json(const AnalysisProblem& problem, const AnalysisResult& result) {
  ordered_json list = ordered_json::array();
  for (const NormalForce& force : normal_forces(problem.mechanism, result.columns)) {
    list.push_back({{"column", force.column},
                    {"body", force.at.body},
                    {"at", {drawn(force.at.at.x), drawn(force.at.at.y)}},
                    {"normal", {drawn(force.normal.x), drawn(force.normal.y)}}});
  }
  return list;
}

ordered_json landmarks_json(const AnalysisProblem& problem, const AnalysisResult& result) {
  const double unit = drive_unit(problem.mechanism);
  ordered_json list = ordered_json::array();
  for (const problems::Landmark& landmark : result.landmarks) {
    list.push_back({{"kind", landmark.kind},
                    {"of", landmark.of},
                    {"drive", drawn(unit * landmark.drive)},
                    {"value", drawn(landmark.value)}});
    if (landmark.again) list.back()["again"] = drawn(unit * *landmark.again);
  }
  return list;
}

}  // namespace

ordered_json analysis_report_data(const AnalysisProblem& problem, const AnalysisResult& result) {
  const auto rows = drawn_rows(result.columns, kAnalysisRows, kAnalysisCells);
  return {{"drive", moved_drive(problem)},
          {"mechanism", mechanism_json(problem)},
          {"table", table_json(problem, result, rows)},
          {"vectors", vectors_json(problem, result)},
          {"normals", normals_json(problem, result)},
          {"loads", load_arrows(problem, result, rows)},
          {"landmarks", landmarks_json(problem, result)},
          {"facts", quantities_json(result.quantities)}};
}

}  // namespace cognate::app
