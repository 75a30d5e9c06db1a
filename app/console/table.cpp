#include "app/console/table.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>

#include "app/console/design_columns.hpp"
#include "app/console/messages.hpp"
#include "app/console/paint.hpp"
#include "app/console/table_text.hpp"
#include "app/console/text_table.hpp"
#include "problems/basics/names.hpp"

namespace cognate::app {
namespace {

using problems::FunctionProblem;
using problems::PathProblem;
using problems::Problem;
using problems::Result;

std::string description(const PathProblem& problem) {
  return fmt::format("path generation{}, {} points, {} timing{}",
                     problem.method == problems::PathMethod::exact ? " exactly" : "",
                     problem.points.size(), problems::to_string(problem.timing),
                     problem.atlas ? ", from the atlas " + problem.atlas->name : "");
}

std::string description(const FunctionProblem& problem) {
  if (const auto* pairs = std::get_if<problems::AnglePairs>(&problem.target)) {
    const bool slider = problem.type == problems::MechanismType::slider_crank;
    return fmt::format("function generation, {} pairs of angles{}", pairs->size(),
                       slider ? " and displacements" : "");
  }
  const auto& function = std::get<problems::FunctionOfX>(problem.target);
  const auto what = function.text.empty()
                        ? fmt::format("a table of {} points", function.table.size())
                        : "y = " + function.text;
  const auto aim =
      problem.objective == problems::FunctionObjective::exact
          ? counted(static_cast<std::size_t>(problem.precision_points), "precision point")
          : counted(problem.sample_at.size(), "sample");
  return fmt::format("function generation, {}, {}", what, aim);
}

std::string description(const problems::MotionProblem& problem) {
  return fmt::format("motion generation, {} poses", problem.poses.size());
}

std::string description(const problems::QuickReturnProblem& problem) {
  return fmt::format("quick return, time ratio {}", problem.time_ratio);
}

std::string description(const problems::StraightLineProblem&) {
  return "approximate straight line";
}

/// Of problems with several objectives.
constexpr FactColumn kMeasureFacts[] = {{"link_ratio", "link ratio"},
                                        {"longest_link", "longest link [length]"}};
constexpr FactColumn kQuickReturnFacts[] = {{"swing_deg", "swing [deg]"},
                                            {"stroke", "stroke [length]"},
                                            {"pressure_angle_deg", "pressure [deg]"}};
constexpr FactColumn kStraightLineFacts[] = {
    {"contact_points", "contact [points]"},
    {"straight_length_at_0_001", "straight to 0.1 % [length]"},
    {"straight_length_at_0_01", "to 1 % [length]"}};
constexpr FactColumn kSearchedLineFacts[] = {{"straight_length", "straight [length]"},
                                             {"deviation_relative", "deviation/length"},
                                             {"size_over_length", "size/length"}};

/// What is told of the designs of each kind of problem.
struct Choice {
  ColumnChoice operator()(const PathProblem&) const {
    return {.error_unit = "length", .facts = kMeasureFacts};
  }
  ColumnChoice operator()(const FunctionProblem& problem) const {
    const bool angles = problem.type == problems::MechanismType::four_bar;
    return {.error_unit = angles ? "deg" : "length",
            .acceleration_unit = "rad/s²",
            .facts = kMeasureFacts};
  }
  ColumnChoice operator()(const problems::MotionProblem&) const {
    return {.error_unit = "length", .facts = kMeasureFacts};
  }
  ColumnChoice operator()(const problems::QuickReturnProblem&) const {
    return {.facts = kQuickReturnFacts};
  }
  ColumnChoice operator()(const problems::StraightLineProblem& problem) const {
    if (problem.goal) return {.coupler_point = true, .facts = kSearchedLineFacts};
    return {.coupler_point = true, .facts = kStraightLineFacts};
  }
};

/// A name as words: "complex_solutions" is "complex solutions", "real.triplets" "real triplets".
std::string words(std::string name) {
  std::ranges::replace_if(
      name, [](char c) { return c == '_' || c == '.'; }, ' ');
  return printable(name);
}

/// The facts of the synthesis as a whole on one line; empty without facts.
std::string facts_line(const Result& result) {
  std::string line;
  for (const auto& fact : result.facts) {
    const auto* number = std::get_if<double>(&fact.value);
    if (number != nullptr && !std::isfinite(*number)) continue;
    if (!line.empty()) line += "; ";
    line += words(fact.name) + ": " + std::visit(WrittenValue{}, fact.value);
  }
  return line.empty() ? line : line + '\n';
}

/// What is proved of the best design.
std::string certificate_line(const Result& result) {
  if (!result.certificate) return {};
  const problems::Certificate& proof = *result.certificate;
  const std::string among = fmt::format("among {} ({} boxes)", proof.domain, proof.boxes);
  if (proof.complete) {
    return fmt::format(
        "certified: sum of squares {:.10g} is within {:.2g} of the least possible, {}\n",
        proof.upper_bound, proof.gap_relative, among);
  }
  return fmt::format(
      "not certified in the time given: sum of squares {:.10g}, least possible at least {:.10g} "
      "(gap {:.2g}), {}\n",
      proof.upper_bound, proof.lower_bound, proof.gap_relative, among);
}

void append_designs(std::string& text, const Problem& problem, const Result& result,
                    const Screen& screen) {
  const auto designs = shown_designs(result);
  if (designs.empty()) return;
  text += table_text(design_columns(designs, std::visit(Choice{}, problem)), screen);
  text += left_out_line(result.designs.size()) + '\n';
}

}  // namespace

std::string describe(const Problem& problem) {
  return std::visit(
      [](const auto& given) {
        const auto what = description(given);
        return printable(given.title.empty() ? what : given.title + ": " + what);
      },
      problem);
}

std::string design_table(const Problem& problem, const Result& result, const Screen& screen) {
  std::string text = describe(problem) + '\n';
  text += status_text(result, screen.colour);
  text += facts_line(result);
  append_designs(text, problem, result, screen);
  return text + violations_text(result, screen.colour) + certificate_line(result) +
         notes_text(result.notes) + work_line(result.work);
}

}  // namespace cognate::app
