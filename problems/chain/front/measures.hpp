/// @file How a chain is measured by what its error is weighed against, and how a search is held to
/// a level of that.
#pragma once

#include <string_view>
#include <vector>

#include "problems/chain/front/measure.hpp"
#include "problems/chain/topology.hpp"
#include "problems/linkage/linkage_limits.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// What a front changes of its problem from search to search.
struct ChainDemand {
  std::vector<Topology> topologies;
  Range transmission_angle;  ///< radians
  Solve solve;
};

/// A measure other than the number of links. Angles are in radians.
struct ChainMeasureRule {
  ChainMeasure measure;
  std::string_view column;  ///< in tables; in degrees for _deg
  bool greatest_is_best;
  double best;  ///< which no design passes
  double step;  ///< between the levels first looked at: radians, or a logarithm
  double (*value)(const std::vector<Topology>& topologies, const Design& design);
  /// Lets `demand` allow no design worse than `value`; false where it then allows none at all.
  bool (*limit)(ChainDemand& demand, double value);

  /// As tables say it.
  double shown(double value) const;
};

const ChainMeasureRule& rule_of(ChainMeasure measure);

/// The one of `topologies` that a design is of.
const Topology& topology_of(const std::vector<Topology>& topologies, const Design& design);

}  // namespace cognate::problems
