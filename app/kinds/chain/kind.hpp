/// @file What the program does with `kind = "path-generation"` of chains of dyads.
#pragma once

#include "app/kinds/linkage/kind.hpp"
#include "problems/chain/problem.hpp"

namespace cognate::app {

template <>
struct Kind<problems::ChainPathProblem> : LinkageKind<problems::ChainPathProblem> {
  static constexpr std::string_view kMeaning =
      "a point of a six-bar, an eight-bar or a chain of dyads passes through given points";
  static constexpr std::string_view kListName = "path-generation (chains)";
  static constexpr std::string_view kMethods =
      "six-bars, eight-bars and chains of dyads by least squares";
  static std::span<const Entry> keys();
  static std::vector<ListSection> sections();
  static std::string describe(const problems::ChainPathProblem& problem);
  static ColumnChoice columns(const problems::ChainPathProblem& problem);
  static nlohmann::ordered_json target_json(const problems::ChainPathProblem& problem);
  static problems::MetricNames metric_names(const problems::ChainPathProblem& base) {
    return chain_metric_names(base.topologies);
  }
  static nlohmann::ordered_json reached_json(const problems::ChainPathProblem& problem,
                                             const problems::Design& design);
  static bool edits(const problems::ChainPathProblem& problem) { return !problem.raster; }
};

}  // namespace cognate::app
