#include "app/table_text.hpp"

#include <fmt/core.h>

#include <cmath>
#include <variant>

#include "app/messages.hpp"

namespace cognate::app {

using problems::Status;

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
  }
  return met;
}

Colour status_colour(Status status, int feasible) {
  if (status == Status::solved) return Colour::green;
  return feasible > 0 ? Colour::yellow : Colour::red;
}

std::string WrittenValue::operator()(double value) const {
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

void append_violations(std::string& text, std::size_t number,
                       std::span<const problems::ConstraintCheck> checks, bool colour) {
  for (const auto& check : checks) {
    if (check.satisfied) continue;
    text += paint(fmt::format("design {} violates {}", number, check.name), Colour::red, colour);
    text += fmt::format(": {}; allowed: {}\n", std::visit(WrittenValue{}, check.value),
                        std::visit(WrittenValue{}, check.bound));
  }
}

std::string work_line(const problems::Work& work) {
  std::string text = fmt::format("{:.3g} s on {}", work.seconds,
                                 counted(static_cast<std::size_t>(work.threads), "thread"));
  if (work.candidates > 0) text += fmt::format(", {} candidates screened", work.candidates);
  return text + '\n';
}

}  // namespace cognate::app
