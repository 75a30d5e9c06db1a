/// @file What the program does with `kind = "motion-generation"`.
#pragma once

#include "app/kinds/linkage/kind.hpp"
#include "problems/guidance/problem.hpp"

namespace cognate::app {

template <>
struct Kind<problems::MotionProblem> : LinkageKind<problems::MotionProblem> {
  static constexpr std::string_view kMeaning = "a body moves through poses";
  static constexpr std::string_view kMethods = "designs by Burmester's theory and by least squares";
  static std::span<const Entry> keys();
  static std::string describe(const problems::MotionProblem& problem);
  static ColumnChoice columns(const problems::MotionProblem& problem);
  static nlohmann::ordered_json target_json(const problems::MotionProblem& problem);
  static nlohmann::ordered_json reached_json(const problems::MotionProblem& problem,
                                             const problems::Design& design);
};

}  // namespace cognate::app
