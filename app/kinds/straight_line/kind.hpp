/// @file What the program does with `kind = "straight-line"`.
#pragma once

#include "app/kinds/linkage/kind.hpp"
#include "problems/straight_line/problem.hpp"

namespace cognate::app {

template <>
struct Kind<problems::StraightLineProblem> : LinkageKind<problems::StraightLineProblem> {
  static constexpr std::string_view kMeaning = "a point of the coupler moves along a straight line";
  static constexpr std::string_view kMethods =
      "designs by minimax search and from the curvature of coupler curves";
  static std::span<const Entry> keys();
  static std::string describe(const problems::StraightLineProblem& problem);
  static ColumnChoice columns(const problems::StraightLineProblem& problem);
  static nlohmann::ordered_json target_json(const problems::StraightLineProblem& problem);
  static nlohmann::ordered_json reached_json(const problems::StraightLineProblem& problem,
                                             const problems::Design& design);
};

}  // namespace cognate::app
