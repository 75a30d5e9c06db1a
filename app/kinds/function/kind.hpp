/// @file What the program does with `kind = "function-generation"`.
#pragma once

#include "app/kinds/linkage/kind.hpp"
#include "problems/function/problem.hpp"

namespace cognate::app {

template <>
struct Kind<problems::FunctionProblem> : LinkageKind<problems::FunctionProblem> {
  static constexpr std::string_view kMeaning =
      "the rocker's angle follows a function of the crank's angle";
  static constexpr std::string_view kMethods =
      "designs by Freudenstein's equation and by least squares";
  static std::span<const Entry> keys();
  static std::string describe(const problems::FunctionProblem& problem);
  static ColumnChoice columns(const problems::FunctionProblem& problem);
  static nlohmann::ordered_json target_json(const problems::FunctionProblem& problem);
  static nlohmann::ordered_json reached_json(const problems::FunctionProblem& problem,
                                             const problems::Design& design);
};

}  // namespace cognate::app
