/// @file How a chain is measured by what its error is weighed against, and how a search is held to
/// a level of that.
#pragma once

#include <string_view>

#include "problems/chain/problem.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// A measure other than the number of links. Angles are in radians.
struct ChainMeasureRule {
  ChainMeasure measure;
  std::string_view column;  ///< in tables; in degrees for _deg
  bool greatest_is_best;
  double best;  ///< which no design passes
  double step;  ///< between the levels first looked at: radians, or a logarithm
  double (*value)(const ChainPathProblem& problem, const Design& design);
  /// Lets `problem` allow no design worse than `value`; false where it then allows none at all.
  bool (*limit)(ChainPathProblem& problem, double value);

  /// As tables say it.
  double shown(double value) const;
};

const ChainMeasureRule& rule_of(ChainMeasure measure);

/// The topology of a design of `problem`.
const Topology& topology_of(const ChainPathProblem& problem, const Design& design);

}  // namespace cognate::problems
