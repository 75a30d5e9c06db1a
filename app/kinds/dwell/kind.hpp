/// @file What the program does with `kind = "function-generation"` whose output is to dwell.
#pragma once

#include "app/kinds/linkage/kind.hpp"
#include "problems/dwell/problem.hpp"

namespace cognate::app {

template <>
struct Kind<problems::DwellProblem> : LinkageKind<problems::DwellProblem> {
  static constexpr std::string_view kMeaning =
      "the output of a six-bar or a chain of dyads stands still over a part of the turn";
  static constexpr std::string_view kListName = "function-generation (dwells)";
  static constexpr std::string_view kMethods =
      "six-bars and chains of dyads whose output stands still over a part of the turn";
  static std::span<const Entry> keys();
  static std::vector<ListSection> sections();
  static std::string describe(const problems::DwellProblem& problem);
  static ColumnChoice columns(const problems::DwellProblem& problem);
  static nlohmann::ordered_json target_json(const problems::DwellProblem& problem);
  static problems::MetricNames metric_names(const problems::DwellProblem& base) {
    return chain_metric_names(base.topologies);
  }
  static bool edits(const problems::DwellProblem& problem) { return !problem.raster; }
};

}  // namespace cognate::app
