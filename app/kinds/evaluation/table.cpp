#include "app/kinds/evaluation/table.hpp"

#include <fmt/core.h>

#include <cmath>
#include <string_view>
#include <variant>

#include "app/console/messages.hpp"
#include "app/console/paint.hpp"
#include "app/console/table_text.hpp"
#include "app/console/text_table.hpp"
#include "app/study/metric_unit.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/basics/names.hpp"
#include "problems/evaluation/output_travel.hpp"

namespace cognate::app {
namespace {

using problems::AnalysisProblem;
using problems::AnalysisResult;
using problems::drive_slides;
using problems::Status;

/// A length, or an angle in degrees to a billionth, so that rounding is not shown as an angle.
std::string number(double value, bool angle) {
  constexpr double kFinest = 1e-9;
  if (!angle) return fmt::format("{:.6g}", value);
  const double shown = std::round(problems::degrees(value) / kFinest) * kFinest;
  return fmt::format("{:.6g}", shown + 0.0);
}

std::string coordinate(double value, bool angle) {
  return number(value, angle) + (angle ? " deg" : "");
}

std::string status_line(const AnalysisResult& result) {
  const std::string positions =
      fmt::format("{} of {} positions", result.closed_rows, result.work.positions);
  switch (result.status) {
    case Status::solved:
      return "solved: the mechanism can be assembled at " + positions;
    case Status::time_limit:
      return "stopped at the time limit: the mechanism can be assembled at " + positions;
    case Status::interrupted:
      return "interrupted: the mechanism can be assembled at " + positions;
    default:
      return "no solution: the mechanism can be assembled at no position";
  }
}

Colour status_colour(const AnalysisResult& result) {
  if (result.status == Status::solved) return Colour::green;
  return result.closed_rows > 0 ? Colour::yellow : Colour::red;
}

struct Written {
  std::string operator()(double value) const { return fmt::format("{:.6g}", value); }
  std::string operator()(bool value) const { return value ? "yes" : "no"; }
  std::string operator()(const std::string& value) const { return printable(value); }
};

void append_facts(std::string& text, const AnalysisResult& result, const Screen& screen) {
  Column names{"metric", Align::left, {}};
  Column values{"value", Align::left, {}};
  Column units{"unit", Align::left, {}};
  for (const auto& fact : result.facts) {
    names.cells.push_back(printable(fact.name));
    values.cells.push_back(std::visit(Written{}, fact.value));
    units.cells.push_back(metric_unit(fact.name));
  }
  if (!names.cells.empty()) text += table_text({names, values, units}, screen);
}

void append_landmarks(std::string& text, const AnalysisProblem& problem,
                      const AnalysisResult& result, const Screen& screen) {
  if (result.landmarks.empty()) return;
  const auto& bodies = problem.mechanism.bodies;
  const auto output = static_cast<std::size_t>(problem.mechanism.output);
  const bool turns = !problems::output_travel(problem.mechanism).slides;
  Column kinds{"landmark", Align::left, {}};
  Column owners{"of", Align::left, {}};
  const auto unit = [](bool angle) { return angle ? " [deg]" : " [length]"; };
  const bool driven_by_angle = !drive_slides(problem);
  Column drives{
      std::string(driven_by_angle ? "crank" : "slide") + unit(driven_by_angle), Align::right, {}};
  Column values{printable(bodies[output]) + unit(turns), Align::right, {}};
  for (const auto& landmark : result.landmarks) {
    kinds.cells.push_back(landmark.again ? fmt::format("{}, also at {}", landmark.kind,
                                                       coordinate(*landmark.again, driven_by_angle))
                                         : landmark.kind);
    owners.cells.push_back(printable(landmark.of));
    drives.cells.push_back(number(landmark.drive, driven_by_angle));
    values.cells.push_back(std::isfinite(landmark.value) ? number(landmark.value, turns) : "–");
  }
  text += table_text({kinds, owners, drives, values}, screen);
}

}  // namespace

std::string describe(const AnalysisProblem& problem) {
  const auto& sweep = problem.drive;
  const bool angle = !drive_slides(problem);
  const auto what =
      fmt::format("analysis of {}, {} {} to {} in {} steps",
                  problems::to_string(problem.mechanism.type), angle ? "crank" : "slide",
                  coordinate(sweep.start, angle), coordinate(sweep.end, angle), sweep.steps);
  return printable(problem.title.empty() ? what : problem.title + ": " + what);
}

std::string analysis_table(const AnalysisProblem& problem, const AnalysisResult& result,
                           const Screen& screen) {
  std::string text = describe(problem) + '\n';
  text += paint(status_line(result), status_colour(result), screen.colour) + '\n';
  append_facts(text, result, screen);
  append_landmarks(text, problem, result, screen);
  text += '\n';
  text += notes_text(result.notes);
  text +=
      fmt::format("{:.3g} s on {} thread{}, {} positions\n", result.work.seconds,
                  result.work.threads, result.work.threads == 1 ? "" : "s", result.work.positions);
  return text;
}

}  // namespace cognate::app
