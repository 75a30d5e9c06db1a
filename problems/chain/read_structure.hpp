/// @file Which points a chain has, and on which points before them they close.
#pragma once

#include <optional>
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

/// The topology that the tables define, without dimensions; empty, with a fault, where they define
/// none. Its `trace` is the last of the points wanted; `target` is the table of their key.
std::optional<Topology> read_structure(PartTables& parts, TableReader& mechanism,
                                       TableReader& target, const Wanted& wanted);

}  // namespace cognate::problems::reading
