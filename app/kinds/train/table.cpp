#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "app/console/design_table.hpp"
#include "app/console/messages.hpp"
#include "app/console/table_text.hpp"
#include "app/kinds/basics/quantity_table.hpp"
#include "app/kinds/train/kind.hpp"
#include "problems/basics/names.hpp"
#include "problems/train/resolve.hpp"

namespace cognate::app {
namespace {

using problems::GearTrainDesign;
using problems::GearTrainProblem;
using problems::GearTrainResult;
using problems::Quantity;

std::string shown(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? fmt::format("{:.6g}", *value) : kNoValue;
}

std::string cell(const GearTrainDesign& design, std::string_view name) {
  const auto found = std::ranges::find(design.metrics, name, &Quantity::name);
  if (found == design.metrics.end()) return kNoValue;
  if (const auto* number = std::get_if<double>(&found->value)) return shown(*number);
  if (const auto* text = std::get_if<std::string>(&found->value)) return printable(*text);
  return std::get<bool>(found->value) ? "yes" : "no";
}

/// "19/53 · 21/47", driver over driven of each pair; "24 + 2·30 = 84, 3 planets".
std::string teeth_text(const GearTrainDesign& design) {
  const auto& train = design.settled;
  if (!train.planets.empty()) {
    return fmt::format("{}, {}, {}; {} planets", train.meshes[0].teeth[0], train.meshes[0].teeth[1],
                       train.meshes[1].teeth[1], train.planets[0].count);
  }
  std::string text;
  for (const auto& mesh : train.meshes) {
    text += fmt::format("{}{}:{}", text.empty() ? "" : " ", mesh.teeth[0], mesh.teeth[1]);
  }
  return text;
}

std::string designs_text(const GearTrainProblem& problem, const GearTrainResult& result,
                         const Screen& screen) {
  DesignTable<GearTrainDesign> columns(result.designs);
  const auto add = [&](const char* heading, const char* metric) {
    columns.add_if_any(heading, Align::right,
                       [&](const auto& design) { return cell(design, metric); });
  };
  add("state", "state");
  if (problem.target) {
    columns.add("teeth", Align::left, [](const auto& design) { return teeth_text(design); });
  }
  add("ratio", "ratio");
  add("exactly", "ratio_exact");
  add("error", "ratio_error");
  add("torque ratio", "torque_ratio");
  add("efficiency", "efficiency");
  add("sum of teeth", "teeth_sum");
  columns.add_constraints();
  return table_text(columns.columns(), screen);
}

std::string members_text(const GearTrainDesign& design, const Screen& screen) {
  std::vector<Column> columns;
  const auto add = [&](const char* heading, Align align, const auto& text) {
    Column column{heading, align, {}};
    for (const auto& member : design.members) column.cells.push_back(text(member));
    const bool is_empty =
        std::ranges::all_of(column.cells, [](const std::string& each) { return each == kNoValue; });
    if (!is_empty) columns.push_back(std::move(column));
  };
  add("member", Align::left, [](const auto& member) { return printable(member.name); });
  add("", Align::left, [](const auto& member) { return member.role; });
  add("of input", Align::right, [](const auto& member) {
    return member.speed_exact.empty() ? kNoValue : member.speed_exact;
  });
  add("speed [rad/s]", Align::right, [](const auto& member) { return shown(member.speed); });
  add("to carrier [rad/s]", Align::right,
      [](const auto& member) { return shown(member.relative_speed); });
  add("torque [N m]", Align::right, [](const auto& member) { return shown(member.torque); });
  add("power [W]", Align::right, [](const auto& member) { return shown(member.power); });
  add("inertia [kg m2]", Align::right,
      [](const auto& member) { return shown(member.equivalent_inertia); });
  return table_text(columns, screen);
}

}  // namespace

std::string Kind<GearTrainProblem>::refusal(const GearTrainProblem& problem, Command command) {
  if (command == Command::solve || !problem.target) return "";
  return "the gear train is to be found; expected 'cognate solve', or a file with [[mesh]] tables";
}

std::string Kind<GearTrainProblem>::describe(const GearTrainProblem& problem) {
  if (problem.target) {
    return titled(problem.title,
                  fmt::format("{} gear train of ratio {:.9g}", to_string(problem.target->train),
                              problem.target->ratio));
  }
  std::string what =
      fmt::format("gear train of {} members and {} mesh{}", problems::member_names(problem).size(),
                  problem.meshes.size(), problem.meshes.size() == 1 ? "" : "es");
  if (!problem.states.empty()) what += fmt::format(", {} states", problem.states.size());
  return titled(problem.title, what);
}

std::string Kind<GearTrainProblem>::table(const GearTrainProblem& problem,
                                          const GearTrainResult& result, const Screen& screen) {
  std::string designs;
  if (result.designs.size() > 1 || problem.target) designs = designs_text(problem, result, screen);
  if (result.designs.size() == 1) {
    const GearTrainDesign& design = result.designs.front();
    designs += members_text(design, screen) + '\n' + quantity_table(design.metrics, screen);
  }
  return result_table({.heading = describe(problem), .designs = designs}, result, screen);
}

}  // namespace cognate::app
