/// @file The search for legs.
#pragma once

#include <limits>
#include <vector>

#include "problems/leg/model.hpp"
#include "problems/linkage/result.hpp"
#include "synthesis/search/multi_start.hpp"

namespace cognate::problems {

/// A leg that was found, in the unit of its space.
struct LegMinimum {
  const LegSpace* space = nullptr;
  LegDesign design;
  double objective = 0;  ///< half band over stride, or the share of the turn out of stance
};

struct LegSearchResult {
  std::vector<LegMinimum> designs;  ///< best first; different ones
  /// Of the topology of the best design; starts of all.
  synthesis::SearchStatistics statistics;
  bool closes = false;  ///< whether a leg was assembled over the whole turn, within limits or not
};

/// Minimax fits from published legs and disturbed ones, from chains drawn at random, and from
/// disturbed good designs.
LegSearchResult search_legs(const std::vector<LegSpace>& spaces, const Solve& options,
                            const Run& run, const Deadline& deadline, Work& work);

}  // namespace cognate::problems
