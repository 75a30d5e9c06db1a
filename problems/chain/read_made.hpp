/// @file How a chain is made: layers of its links and tolerances of its dimensions.
#pragma once

#include <algorithm>
#include <string_view>

#include "problems/chain/read_design.hpp"
#include "problems/chain/read_tolerances.hpp"
#include "problems/layers/read.hpp"
#include "problems/linkage/design_layers.hpp"

namespace cognate::problems::reading {

/// `[layers]` and `[tolerance]` of a problem whose error is in `unit`, once its topologies, front
/// and constraints have been read. Of links with three pins, which have neither and whose limits
/// hold `over` a turn, they are faults.
template <class AnyProblem>
void read_made(TableReader& document, LinkageTables& tables, std::string_view unit, LimitSpan over,
               AnyProblem& problem) {
  if (std::ranges::any_of(problem.topologies, has_three_pin_link)) {
    return refuse_with_three_pins(document, tables, over);
  }
  problem.layers = read_design_layers(document, tables.constraints, links_of(problem.topologies),
                                      problem.against ? kNoLayersOfFronts : std::string_view{});
  problem.tolerances = read_chain_tolerances(document, problem.topologies, unit);
}

}  // namespace cognate::problems::reading
