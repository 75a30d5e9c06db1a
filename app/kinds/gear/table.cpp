#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "app/console/design_table.hpp"
#include "app/console/messages.hpp"
#include "app/console/table_text.hpp"
#include "app/documents/csv.hpp"
#include "app/kinds/basics/quantity_table.hpp"
#include "app/kinds/gear/kind.hpp"
#include "problems/basics/names.hpp"

namespace cognate::app {
namespace {

using problems::Gearing;
using problems::GearPairDesign;
using problems::GearPairProblem;
using problems::GearPairResult;
using problems::GearProblem;
using problems::GearResult;
using problems::Quantity;
using problems::to_string;

/// "teeth, module", what is found.
std::string free_parts(const GearPairProblem& problem) {
  if (!is_searched(problem.gearing)) return {};
  std::string text;
  const auto add = [&](const char* name) {
    text += fmt::format("{}{}", text.empty() ? "" : ", ", name);
  };
  if (!problem.teeth[0]) add("teeth");
  if (!problem.module) add("module");
  if (!problem.profile_shift[0] || !problem.profile_shift[1]) add("profile shifts");
  if (!problem.centre_distance && !text.empty()) add("centre distance");
  if (problem.free_helix) add("helix angle");
  return text;
}

std::string teeth_text(const GearPairProblem& problem) {
  if (problem.gearing == Gearing::worm) {
    return fmt::format(" of {:g} start{} and {:g} teeth", problem.worm.starts,
                       problem.worm.starts == 1 ? "" : "s", problem.worm.wheel_teeth);
  }
  if (!problem.teeth[0] || !problem.teeth[1]) return {};
  return fmt::format(" of {} and {} teeth", *problem.teeth[0], *problem.teeth[1]);
}

bool is_shown(const Quantity& quantity) {
  const auto* number = std::get_if<double>(&quantity.value);
  return number == nullptr || std::isfinite(*number);
}

/// With the symbols of ISO 21771.
std::string quantities_text(std::vector<Quantity> quantities, const Screen& screen) {
  std::erase_if(quantities, [](const Quantity& quantity) { return !is_shown(quantity); });
  std::vector<Metric> listed(gear_metrics().begin(), gear_metrics().end());
  listed.insert(listed.end(), gear_pair_metrics().begin(), gear_pair_metrics().end());
  return quantity_table(quantities, screen, listed);
}

std::string cell(const GearPairDesign& design, std::string_view name) {
  const auto found = std::ranges::find(design.metrics, name, &Quantity::name);
  if (found == design.metrics.end() || !is_shown(*found)) return kNoValue;
  const auto* number = std::get_if<double>(&found->value);
  return number ? fmt::format("{:.6g}", *number) : kNoValue;
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
  DesignTable<GearPairDesign> columns(designs);
  for (const auto& shown : kShown) {
    columns.add(shown.heading, Align::right,
                [&](const auto& design) { return cell(design, shown.metric); });
  }
  columns.add_constraints();
  return table_text(columns.columns(), screen);
}

std::string tests_line(const GearPairResult& result) {
  std::string text;
  for (const Quantity& quantity : result.quantities) {
    const auto* number = std::get_if<double>(&quantity.value);
    if (number == nullptr || (*number == 0 && quantity.name.starts_with("refused"))) continue;
    text += fmt::format("{}{} {:.0f}", text.empty() ? "" : ", ", quantity.name, *number);
  }
  std::ranges::replace(text, '_', ' ');
  return text.empty() ? text : text + '\n';
}

}  // namespace

std::string Kind<GearProblem>::refusal(const GearProblem& /*problem*/, Command command) {
  if (command == Command::analyze) return "";
  return "kind is \"gear\": there is nothing to solve, 'cognate analyze' evaluates this gear; "
         "expected a design problem";
}

std::string Kind<GearPairProblem>::refusal(const GearPairProblem& problem, Command command) {
  if (command == Command::solve || is_whole(problem)) return "";
  return "the gear pair is not whole; expected teeth, module and both values of profile_shift, or "
         "'cognate solve', which finds them";
}

std::string Kind<GearProblem>::describe(const GearProblem& problem) {
  const auto& gear = problem.gear.normal;
  return titled(problem.title, fmt::format("{} gear of {:g} teeth, module {:g}",
                                           to_string(problem.gearing), gear.teeth, gear.module));
}

std::string Kind<GearPairProblem>::describe(const GearPairProblem& problem) {
  const bool is_rack = problem.gearing == Gearing::rack;
  std::string what =
      is_rack ? fmt::format("pinion of {} teeth on a rack", problem.teeth[0].value_or(0))
              : fmt::format("{} gear pair{}", to_string(problem.gearing), teeth_text(problem));
  if (problem.module) what += fmt::format(", module {:g}", *problem.module);
  const std::string free = free_parts(problem);
  if (!free.empty()) what += ", free: " + free;
  return titled(problem.title, what);
}

std::string Kind<GearProblem>::table(const GearProblem& problem, const GearResult& result,
                                     const Screen& screen) {
  const bool sound = result.status == problems::Status::solved;
  std::string text = describe(problem) + '\n';
  text += paint(sound ? "solved: nothing is wrong with the gear"
                      : "infeasible: something is wrong with the gear",
                sound ? Colour::green : Colour::red, screen.colour) +
          '\n';
  return text + quantities_text(result.metrics, screen) + '\n' + notes_text(result.notes);
}

std::string Kind<GearProblem>::csv(const GearProblem& problem, const GearResult& result) {
  return csv_text(result.columns, {}, length_word(problem.length_unit));
}

std::string Kind<GearPairProblem>::table(const GearPairProblem& problem,
                                         const GearPairResult& result, const Screen& screen) {
  const auto shown = shown_designs(result);
  const bool given = is_whole(problem);
  std::string designs;
  if (!shown.empty() && !given) designs += designs_text(shown, screen);
  if (!shown.empty() && (given || shown.size() == 1)) {
    designs += quantities_text(shown.front().metrics, screen);
  }
  return result_table(
      {.heading = describe(problem), .designs = designs, .after = tests_line(result)}, result,
      screen);
}

}  // namespace cognate::app
