/// @file The points for which a chain is designed.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "problems/chain/read_parts.hpp"

namespace cognate::problems::reading {

/// The points for which a chain is designed: one whose path counts, two of a link whose angle does,
/// or the pin of a slider.
struct Wanted {
  std::string_view key;             ///< of `[target]`, which names them
  std::vector<std::string> points;  ///< empty: the path of the last point
  bool slides = false;              ///< the one point is a slider, whose displacement counts
};

/// Where a chain and what is wanted of it stand.
struct WantedTables {
  PartTables& parts;
  TableReader& mechanism;
  TableReader& target;
};

/// Makes the last of the points wanted the `trace` of `topology`. False, with a fault, where the
/// chain has no such points or one on which they do not depend.
bool choose_wanted(Topology& topology, const WantedTables& tables, const Wanted& wanted);

/// The names of the points of a chain, for messages.
std::string quoted_points(const Topology& topology);

}  // namespace cognate::problems::reading
