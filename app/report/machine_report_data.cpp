#include "app/report/machine_report_data.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/report/drawn_number.hpp"
#include "app/report/drawn_rows.hpp"
#include "app/report/mechanism_json.hpp"
#include "app/report/quantity_json.hpp"
#include "problems/basics/names.hpp"

namespace cognate::app {
namespace {

using nlohmann::ordered_json;
using problems::MachineMotion;
using problems::MachineProblem;
using problems::MachineResult;

/// Rows and values of the table of a motion that a page holds at most.
constexpr std::size_t kMachineRows = 721, kMachineCells = 40'000;

ordered_json motion_json(const MachineMotion& motion) {
  const auto rows = drawn_rows(motion.columns, kMachineRows, kMachineCells);
  ordered_json columns = ordered_json::array();
  for (const problems::Column& column : motion.columns) {
    ordered_json values = ordered_json::array();
    for (const std::size_t row : rows) values.push_back(drawn(column.values.at(row)));
    columns.push_back({{"name", column.name}, {"values", values}});
  }
  const std::size_t all = motion.columns.empty() ? 0 : motion.columns.front().values.size();
  return {{"task", problems::to_string(motion.task)}, {"rows", all}, {"columns", columns}};
}

/// Whether the mechanism comes back after two turns only: then the steady motion is of two.
bool takes_two_turns(const MachineResult& result) {
  for (const auto& [task, columns] : result.motions) {
    if (task != problems::MachineTask::steady) continue;
    const auto drive = std::ranges::find(columns, "crank_deg", &problems::Column::name);
    if (drive == columns.end() || drive->values.empty()) continue;
    return drive->values.back() - drive->values.front() > 540;
  }
  return false;
}

}  // namespace

ordered_json machine_report_data(const MachineProblem& problem, const MachineResult& result) {
  ordered_json data = {{"mechanism", nullptr},
                       {"drive", nullptr},
                       {"motions", ordered_json::array()},
                       {"facts", quantities_json(result.quantities)}};
  for (const MachineMotion& motion : result.motions) data["motions"].push_back(motion_json(motion));
  if (problem.mechanism) {
    problems::AnalysisProblem shown = *problem.mechanism;
    if (takes_two_turns(result)) shown.drive.end += shown.drive.end - shown.drive.start;
    data["mechanism"] = mechanism_json(shown);
    data["drive"] = drive_json(shown.mechanism, {shown.drive.start, shown.drive.end, true});
  }
  return data;
}

}  // namespace cognate::app
