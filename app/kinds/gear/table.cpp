#include "app/kinds/gear/table.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "app/console/messages.hpp"
#include "app/console/table_text.hpp"
#include "app/console/text_table.hpp"
#include "app/kinds/gear/description.hpp"
#include "app/study/metric_unit.hpp"
#include "problems/linkage/verify.hpp"

namespace cognate::app {
namespace {

using problems::Fact;
using problems::GearPairDesign;
using problems::GearPairProblem;
using problems::GearPairResult;

bool is_shown(const Fact& fact) {
  const auto* number = std::get_if<double>(&fact.value);
  return number == nullptr || std::isfinite(*number);
}

std::string facts_text(const std::vector<Fact>& facts, const Screen& screen) {
  Column names{"metric", Align::left, {}}, values{"value", Align::left, {}},
      units{"unit", Align::left, {}};
  for (const Fact& fact : facts) {
    if (!is_shown(fact)) continue;
    names.cells.push_back(printable(fact.name));
    values.cells.push_back(std::visit(WrittenValue{}, fact.value));
    units.cells.push_back(metric_unit(fact.name));
  }
  return table_text({names, values, units}, screen);
}

std::string cell(const GearPairDesign& design, std::string_view name) {
  const auto found = std::ranges::find(design.metrics, name, &Fact::name);
  if (found == design.metrics.end() || !is_shown(*found)) return "–";
  const auto* number = std::get_if<double>(&found->value);
  return number ? fmt::format("{:.6g}", *number) : "–";
}

std::string constraints_text(const GearPairDesign& design) {
  const auto missed =
      std::ranges::count(design.constraints, false, &problems::ConstraintCheck::satisfied);
  return missed == 0 ? "all met" : fmt::format("{} missed", missed);
}

std::string designs_text(std::span<const GearPairDesign> designs, const Screen& screen) {
  struct Shown {
    const char* heading;
    const char* metric;
  };
  constexpr Shown kShown[] = {{"z1", "pinion.teeth"},
                              {"z2", "wheel.teeth"},
                              {"module [length]", "module"},
                              {"x1", "pinion.profile_shift"},
                              {"x2", "wheel.profile_shift"},
                              {"centre distance [length]", "centre_distance"},
                              {"contact ratio", "contact_ratio"},
                              {"sliding", "sliding_max"},
                              {"backlash [length]", "backlash"}};
  std::vector<Column> columns{{"#", Align::right, {}}};
  for (std::size_t i = 0; i < designs.size(); ++i) {
    columns.front().cells.push_back(std::to_string(i + 1));
  }
  const auto add = [&](std::string heading, Align align, const auto& text) {
    Column column{std::move(heading), align, {}};
    for (const auto& design : designs) column.cells.push_back(text(design));
    columns.push_back(std::move(column));
  };
  for (const auto& shown : kShown) {
    add(shown.heading, Align::right,
        [&](const auto& design) { return cell(design, shown.metric); });
  }
  add("constraints", Align::left, constraints_text);
  return table_text(columns, screen);
}

std::string tests_line(const GearPairResult& result) {
  std::string text;
  for (const Fact& fact : result.facts) {
    const auto* number = std::get_if<double>(&fact.value);
    if (number == nullptr || (*number == 0 && fact.name.starts_with("refused"))) continue;
    text += fmt::format("{}{} {:.0f}", text.empty() ? "" : ", ", fact.name, *number);
  }
  std::ranges::replace(text, '_', ' ');
  return text.empty() ? text : text + '\n';
}

}  // namespace

std::string gear_table(const problems::GearProblem& problem, const problems::GearResult& result,
                       const Screen& screen) {
  const bool sound = result.status == problems::Status::solved;
  std::string text = describe(problem) + '\n';
  text += paint(sound ? "solved: nothing is wrong with the gear"
                      : "infeasible: something is wrong with the gear",
                sound ? Colour::green : Colour::red, screen.colour) +
          '\n';
  return text + facts_text(result.metrics, screen) + '\n' + notes_text(result.notes);
}

std::string gear_pair_table(const GearPairProblem& problem, const GearPairResult& result,
                            const Screen& screen) {
  std::string text = describe(problem) + '\n';
  text += status_text(result, screen.colour);
  const auto shown = shown_designs(result);
  const bool given = is_whole(problem);
  if (!shown.empty() && !given) text += designs_text(shown, screen);
  if (!shown.empty() && (given || shown.size() == 1)) {
    text += facts_text(shown.front().metrics, screen);
  }
  return text + left_out_line(result.designs.size()) + '\n' +
         violations_text(result, screen.colour) + tests_line(result) + notes_text(result.notes) +
         work_line(result.work);
}

}  // namespace cognate::app
