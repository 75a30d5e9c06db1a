/// @file What the program does with `kind = "motion-generation"` of chains.
#pragma once

#include "app/kinds/linkage/kind.hpp"
#include "problems/chain_motion/problem.hpp"

namespace cognate::app {

template <>
struct Kind<problems::ChainMotionProblem> : LinkageKind<problems::ChainMotionProblem> {
  static constexpr std::string_view kMeaning =
      "a link of a six-bar, an eight-bar or a chain of dyads carries a body through poses";
  static constexpr std::string_view kListName = "motion-generation (chains)";
  static constexpr std::string_view kMethods =
      "six-bars, eight-bars and chains of dyads by least squares";
  static std::span<const Entry> keys();
  static std::string describe(const problems::ChainMotionProblem& problem);
  static ColumnChoice columns(const problems::ChainMotionProblem& problem);
  static nlohmann::ordered_json target_json(const problems::ChainMotionProblem& problem);
  static problems::MetricNames metric_names(const problems::ChainMotionProblem& base) {
    return chain_metric_names(base.topologies);
  }
  static nlohmann::ordered_json reached_json(const problems::ChainMotionProblem& problem,
                                             const problems::Design& design);
};

}  // namespace cognate::app
