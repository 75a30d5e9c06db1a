#include "app/console/table_text.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include "app/console/messages.hpp"
#include "problems/basics/enumeration.hpp"
#include "problems/basics/length_unit.hpp"
#include "problems/linkage/constraint_words.hpp"

namespace cognate::app {

using problems::Status;

namespace {

/// "1, 3 to 5 and 8" of rising numbers.
std::string number_list(const std::vector<std::size_t>& numbers) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < numbers.size();) {
    std::size_t last = i;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
    if (last > i + 1) {
      parts.push_back(fmt::format("{} to {}", numbers[i], numbers[last]));
      i = last + 1;
    } else {
      parts.push_back(fmt::format("{}", numbers[i++]));
    }
  }
  return problems::enumeration(parts);
}

/// The name of a constraint, followed by its words where these say more.
std::string name_with_words(const std::string& name, const std::string& label) {
  const auto letters = [](std::string text) {
    std::erase_if(text, [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); });
    return text;
  };
  return letters(name).find(letters(label)) != std::string::npos
             ? name
             : fmt::format("{}, the {}", name, label);
}

/// "at most 5", "40…140", "crank-rocker".
std::string allowed_text(const problems::ConstraintCheck& check, std::string_view relation) {
  const std::string bound = std::visit(WrittenValue{}, check.bound);
  if (!std::holds_alternative<double>(check.bound)) return bound;
  if (relation == "<=") return "at most " + bound;
  return relation == ">=" ? "at least " + bound : bound;
}

}  // namespace

std::string counted(std::size_t count, std::string_view noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

std::string status_line(Status status, std::size_t designs, int feasible) {
  auto met = designs == 0
                 ? std::string("no design found")
                 : fmt::format("{}; {} meet{} every constraint", counted(designs, "design"),
                               feasible, feasible == 1 ? "s" : "");
  switch (status) {
    case Status::solved:
      return "solved: " + met;
    case Status::infeasible:
      return "infeasible: no design satisfies every constraint; the nearest follow";
    case Status::no_solution:
      return "no solution: " + met;
    case Status::time_limit:
      return "stopped at the time limit: " + met;
    case Status::interrupted:
      return "interrupted: " + met;
    case Status::invalid:
      return "invalid: " + met;
  }
  return met;
}

std::string left_out_line(std::size_t designs) {
  if (designs <= kShownDesigns) return {};
  return fmt::format("and {} more, which the result file and the report hold\n",
                     designs - kShownDesigns);
}

std::string notes_text(std::span<const std::string> notes) {
  std::string text;
  for (const auto& note : notes) text += "note: " + printable(note) + '\n';
  return text;
}

Colour status_colour(Status status, int feasible) {
  if (status == Status::solved) return Colour::green;
  return feasible > 0 ? Colour::yellow : Colour::red;
}

std::string WrittenValue::operator()(double value) const {
  if (!std::isfinite(value)) return std::isnan(value) ? "not defined" : "unbounded";
  return fmt::format("{:.6g}", value);
}

std::string WrittenValue::operator()(bool value) const {
  return value ? "yes" : "no";
}

std::string WrittenValue::operator()(const std::string& value) const {
  return printable(value);
}

std::string WrittenValue::operator()(const problems::Range& range) const {
  if (std::isinf(range.max)) return fmt::format("at least {:.6g}", range.min);
  if (std::isinf(range.min)) return fmt::format("at most {:.6g}", range.max);
  return fmt::format("{:.6g}…{:.6g}", range.min, range.max);
}

void Violations::add(std::size_t number, std::span<const problems::ConstraintCheck> checks) {
  for (const auto& check : checks) {
    if (check.satisfied) continue;
    const problems::ConstraintWords words = problems::words_of(check);
    const std::string name = name_with_words(check.name, words.label);
    const std::string unit = problems::in_length_unit(words.unit, length_);
    const auto values =
        fmt::format("{}{}{}; allowed: {}", std::visit(WrittenValue{}, check.value),
                    unit.empty() ? "" : " ", unit, allowed_text(check, words.relation));
    const auto same = [&](const Line& line) { return line.name == name && line.values == values; };
    auto line = std::ranges::find_if(lines_, same);
    if (line == lines_.end()) line = lines_.insert(line, {name, values, {}});
    line->designs.push_back(number);
  }
}

std::string Violations::text(bool colour) const {
  std::string text;
  for (const Line& line : lines_) {
    const bool one = line.designs.size() == 1;
    const auto what = fmt::format("design{} {} violate{} {}", one ? "" : "s",
                                  number_list(line.designs), one ? "s" : "", line.name);
    text += paint(what, Colour::red, colour) + ": " + line.values + '\n';
  }
  return text;
}

std::string warnings_text(std::span<const std::string> warnings, bool colour) {
  std::string text;
  for (const auto& warning : warnings) {
    text += paint("warning:", Colour::yellow, colour) + ' ' + printable(warning) + '\n';
  }
  return text;
}

std::string work_line(const problems::Work& work) {
  std::string text = fmt::format("{:.3g} s on {}", work.seconds,
                                 counted(static_cast<std::size_t>(work.threads), "thread"));
  if (work.candidates > 0) {
    text += ", " + counted(work.candidates, "candidate") + " screened";
  }
  return text + '\n';
}

}  // namespace cognate::app
