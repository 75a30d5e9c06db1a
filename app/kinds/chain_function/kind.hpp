/// @file What the program does with `kind = "function-generation"` whose mechanism is a chain.
#pragma once

#include "app/kinds/linkage/kind.hpp"
#include "problems/chain_function/problem.hpp"

namespace cognate::app {

template <>
struct Kind<problems::ChainFunctionProblem> : LinkageKind<problems::ChainFunctionProblem> {
  static constexpr std::string_view kMeaning =
      "an output angle or a slider of a six-bar or a chain of dyads follows a function of the "
      "crank's angle";
  static constexpr std::string_view kListName = "function-generation (chains)";
  static constexpr std::string_view kMethods =
      "six-bars and chains of dyads whose output follows a function";
  static std::span<const Entry> keys();
  static std::string describe(const problems::ChainFunctionProblem& problem);
  static ColumnChoice columns(const problems::ChainFunctionProblem& problem);
  static bool edits(const problems::ChainFunctionProblem& /*problem*/) { return true; }
  static nlohmann::ordered_json target_json(const problems::ChainFunctionProblem& problem);
  static nlohmann::ordered_json reached_json(const problems::ChainFunctionProblem& problem,
                                             const problems::Design& design);
  static problems::MetricNames metric_names(const problems::ChainFunctionProblem& base) {
    return chain_metric_names(base.topologies);
  }
};

}  // namespace cognate::app
