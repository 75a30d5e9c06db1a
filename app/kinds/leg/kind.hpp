/// @file What the program does with `kind = "leg"`.
#pragma once

#include "app/kinds/linkage/kind.hpp"
#include "problems/leg/problem.hpp"

namespace cognate::app {

template <>
struct Kind<problems::LegProblem> : LinkageKind<problems::LegProblem> {
  static constexpr std::string_view kMeaning =
      "the foot of a walking leg moves straight along the ground over a part of the turn";
  static constexpr std::string_view kMethods =
      "legs of Klann, of Jansen or of any chain of dyads: flattest stance, or longest";
  static std::span<const Entry> keys();
  static std::vector<ListSection> sections();
  static std::string describe(const problems::LegProblem& problem);
  static ColumnChoice columns(const problems::LegProblem& problem);
  static nlohmann::ordered_json target_json(const problems::LegProblem& problem);
  static problems::MetricNames metric_names(const problems::LegProblem& base) {
    return chain_metric_names(base.topologies);
  }
  static bool edits(const problems::LegProblem& /*problem*/) { return true; }
};

}  // namespace cognate::app
