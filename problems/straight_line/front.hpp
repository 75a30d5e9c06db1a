/// @file The Pareto front of straight lines: the least δ/L for each size of the linkage over L.
#pragma once

#include <vector>

#include "problems/straight_line/search.hpp"

namespace cognate::problems {

struct SegmentFront {
  std::vector<SegmentDesign>
      points;    ///< from the largest linkage to the smallest, `designs` at most
  Family table;  ///< all points: measures of each
};

/// The method of the ε-constraint: the largest dimension over the length is bounded and δ/L
/// minimised, for bounds in equal ratios down from `size_limit` until segments
/// are no longer straight; then each again from its neighbours. In the search's unit.
SegmentFront segment_front(const StraightLineProblem& problem, const Run& run,
                           const Deadline& deadline, Work& work);

}  // namespace cognate::problems
