#include <fmt/core.h>

#include <cmath>
#include <string_view>
#include <utility>
#include <variant>

#include "app/console/layers_table.hpp"
#include "app/console/messages.hpp"
#include "app/console/paint.hpp"
#include "app/console/table_text.hpp"
#include "app/console/text_table.hpp"
#include "app/console/tolerance_table.hpp"
#include "app/documents/csv.hpp"
#include "app/kinds/basics/quantity_table.hpp"
#include "app/kinds/evaluation/kind.hpp"
#include "app/report/filled_page.hpp"
#include "app/report/page.hpp"
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

/// The kind of a key position in words: "minimum transmission angle".
std::string words(std::string kind) {
  for (const auto& [key, word] :
       {std::pair("least ", "minimum "), std::pair("greatest ", "maximum ")}) {
    if (kind.starts_with(key)) return kind.replace(0, std::string_view(key).size(), word);
  }
  return kind;
}

void append_landmarks(std::string& text, const AnalysisProblem& problem,
                      const AnalysisResult& result, const Screen& screen) {
  if (result.landmarks.empty()) return;
  const auto& bodies = problem.mechanism.bodies;
  const auto output = static_cast<std::size_t>(problem.mechanism.output);
  const bool turns = !problems::output_travel(problem.mechanism).slides;
  Column kinds{"key position", Align::left, {}};
  Column owners{"of", Align::left, {}};
  const auto unit = [](bool angle) { return angle ? " [deg]" : " [length]"; };
  const bool driven_by_angle = !drive_slides(problem);
  Column drives{
      std::string(driven_by_angle ? "crank" : "slide") + unit(driven_by_angle), Align::right, {}};
  Column values{printable(bodies[output]) + unit(turns), Align::right, {}};
  for (const auto& landmark : result.landmarks) {
    kinds.cells.push_back(words(landmark.kind));
    if (landmark.again) {
      kinds.cells.back() += ", also at " + coordinate(*landmark.again, driven_by_angle);
    }
    owners.cells.push_back(printable(landmark.of));
    drives.cells.push_back(number(landmark.drive, driven_by_angle));
    values.cells.push_back(std::isfinite(landmark.value) ? number(landmark.value, turns) : "–");
  }
  text += table_text({kinds, owners, drives, values}, screen);
}

}  // namespace

std::string Kind<AnalysisProblem>::refusal(const AnalysisProblem& /*problem*/, Command command) {
  if (command == Command::analyze) return "";
  return "kind is \"analysis\": there is nothing to solve, 'cognate analyze' evaluates this "
         "mechanism; expected a design problem";
}

std::string Kind<AnalysisProblem>::describe(const AnalysisProblem& problem) {
  const auto& sweep = problem.drive;
  const bool angle = !drive_slides(problem);
  const auto what =
      fmt::format("analysis of {}, {} {} to {} in {} steps",
                  problems::to_string(problem.mechanism.type()), angle ? "crank" : "slide",
                  coordinate(sweep.start, angle), coordinate(sweep.end, angle), sweep.steps);
  return titled(problem.title, what);
}

std::string Kind<AnalysisProblem>::table(const AnalysisProblem& problem,
                                         const AnalysisResult& result, const Screen& screen) {
  std::string text = describe(problem) + '\n';
  text += paint(status_line(result), status_colour(result), screen.colour) + '\n';
  text += quantity_table(result.quantities, screen);
  append_landmarks(text, problem, result, screen);
  if (result.tolerance) text += tolerance_table(*result.tolerance, screen);
  if (result.layers) text += layers_table(*result.layers, drive_slides(problem), screen);
  text += '\n';
  text += notes_text(result.notes);
  text +=
      fmt::format("{:.3g} s on {} thread{}, {} positions\n", result.work.seconds,
                  result.work.threads, result.work.threads == 1 ? "" : "s", result.work.positions);
  return text;
}

std::string Kind<AnalysisProblem>::csv(const AnalysisProblem& problem,
                                       const AnalysisResult& result) {
  return csv_text(result.columns, {}, length_word(problem.length_unit));
}

std::string Kind<AnalysisProblem>::page(const AnalysisProblem& problem,
                                        const AnalysisResult& /*result*/) {
  // What is edited is evaluated anew at every change.
  constexpr std::size_t kMostBodies = 40;
  constexpr int kMostSteps = 5000;
  const bool editable =
      problem.mechanism.bodies.size() <= kMostBodies && problem.drive.steps <= kMostSteps;
  return editable ? analysis_page() : without_kernel(analysis_page(), "kernel");
}

}  // namespace cognate::app
