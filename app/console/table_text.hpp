/// @file What the tables of all kinds of designs have in common.
#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/console/paint.hpp"
#include "app/console/screen.hpp"
#include "problems/linkage/result.hpp"
#include "problems/linkage/verify.hpp"

namespace cognate::app {

/// How many designs are printed.
inline constexpr std::size_t kShownDesigns = 20;

/// "1 design", "3 designs".
std::string counted(std::size_t count, std::string_view noun);

/// The status in words with what was found: `feasible` of `designs` meet every constraint.
std::string status_line(problems::Status status, std::size_t designs, int feasible);

/// The number of `result`'s designs, of any kind, that meet every constraint.
template <class AnyResult>
int feasible_count(const AnyResult& result) {
  return static_cast<int>(std::ranges::count_if(result.designs, [](const auto& design) {
    return problems::all_satisfied(design.constraints);
  }));
}

/// Those of `result`'s designs that are printed, and a line for the others if there are any.
template <class AnyResult>
auto shown_designs(const AnyResult& result) {
  return std::span(result.designs).first(std::min(kShownDesigns, result.designs.size()));
}
std::string left_out_line(std::size_t designs);

/// Green where all is well, yellow where a stopped run has found something, red without a design.
Colour status_colour(problems::Status status, int feasible);

/// A value of a quantity, or of one side of a check, as text.
struct WrittenValue {
  std::string operator()(double value) const;
  std::string operator()(bool value) const;
  std::string operator()(const std::string& value) const;
  std::string operator()(const problems::Range& range) const;
};

/// Which designs violate what: one line for all that violate a constraint by the same value.
class Violations {
 public:
  /// `length`: the word for the unit of lengths, or empty.
  explicit Violations(std::string length) : length_(std::move(length)) {}

  /// The checks of the design `number`.
  void add(std::size_t number, std::span<const problems::ConstraintCheck> checks);
  /// "designs 2 and 5 to 8 violate class: rocker-crank; allowed: crank-rocker", "design 3 violates
  /// tip_clearance_min.pinion, the tip clearance (pinion): 0.1 module; allowed: at least 0.2", and
  /// so on.
  std::string text(bool colour) const;

 private:
  struct Line {
    std::string name;
    std::string values;  ///< what it is and what is allowed
    std::vector<std::size_t> designs;
  };
  std::string length_;
  std::vector<Line> lines_;  ///< in the order in which the first design of each came
};

/// The status of `result` in words, coloured, with the end of the line.
template <class AnyResult>
std::string status_text(const AnyResult& result, bool colour) {
  const int feasible = feasible_count(result);
  return paint(status_line(result.status, result.designs.size(), feasible),
               status_colour(result.status, feasible), colour) +
         '\n';
}

/// What those of `result`'s designs that are printed violate.
template <class AnyResult>
std::string violations_text(const AnyResult& result, const Screen& screen) {
  Violations violations(screen.length);
  std::size_t number = 0;
  for (const auto& design : shown_designs(result)) violations.add(++number, design.constraints);
  return violations.text(screen.colour);
}

/// The parts of the table of a result that differ from kind to kind.
struct ResultTable {
  std::string heading;
  std::string designs;  ///< empty where there is none
  std::string after;    ///< lines after what designs violate
};

/// A heading, the status in words, the designs, for each of these that violates a constraint what
/// it violates, the notes, and the time.
template <class AnyResult>
std::string result_table(const ResultTable& parts, const AnyResult& result, const Screen& screen);

/// A line for each note.
std::string notes_text(std::span<const std::string> notes);

/// A line for each warning.
std::string warnings_text(std::span<const std::string> warnings, bool colour);

/// "0.5 s on 2 threads, 12 candidates screened", with the end of the line.
std::string work_line(const problems::Work& work);

template <class AnyResult>
std::string result_table(const ResultTable& parts, const AnyResult& result, const Screen& screen) {
  std::string text = parts.heading + '\n' + status_text(result, screen.colour);
  if (!parts.designs.empty()) {
    text += parts.designs + left_out_line(result.designs.size()) + '\n';
  }
  text += violations_text(result, screen) + parts.after;
  if constexpr (requires { result.warnings; }) {
    text += warnings_text(result.warnings, screen.colour);
  }
  return text + notes_text(result.notes) + work_line(result.work);
}

}  // namespace cognate::app
