/// @file What the tables of all kinds of designs have in common.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/paint.hpp"
#include "problems/result.hpp"

namespace cognate::app {

/// How many designs are printed.
inline constexpr std::size_t kShownDesigns = 20;

/// "1 design", "3 designs".
std::string counted(std::size_t count, std::string_view noun);

/// The status in words with what was found: `feasible` of `designs` meet every constraint.
std::string status_line(problems::Status status, std::size_t designs, int feasible);

/// Green where all is well, yellow where a stopped run has found something, red without a design.
Colour status_colour(problems::Status status, int feasible);

/// A value of a fact, or of one side of a check, as text.
struct WrittenValue {
  std::string operator()(double value) const;
  std::string operator()(bool value) const;
  std::string operator()(const std::string& value) const;
  std::string operator()(const problems::Range& range) const;
};

/// Which designs violate what: one line for all that violate a constraint by the same value.
class Violations {
 public:
  /// The checks of the design `number`.
  void add(std::size_t number, std::span<const problems::ConstraintCheck> checks);
  /// "designs 2 and 5 to 8 violate class: rocker-crank; allowed: crank-rocker", and so on.
  std::string text(bool colour) const;

 private:
  struct Line {
    std::string name;
    std::string values;  ///< what it is and what is allowed
    std::vector<std::size_t> designs;
  };
  std::vector<Line> lines_;  ///< in the order in which the first design of each came
};

/// "0.5 s on 2 threads, 12 candidates screened", with the end of the line.
std::string work_line(const problems::Work& work);

}  // namespace cognate::app
