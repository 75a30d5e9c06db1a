/// @file The best pairs of dyads.
#pragma once

#include <cstdint>
#include <vector>

#include "problems/guidance/design.hpp"
#include "problems/guidance/dyad_choices.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// A pair and what it is worth, in the order of driving that serves better.
struct RankedPair {
  DyadPair pair;
  Judgement judgement;
};

struct RankedPairs {
  std::vector<RankedPair> pairs;  ///< best first
  std::uint64_t judged = 0;       ///< mechanisms looked at
};

/// All pairs where both dyads are lists. Where pivots are given the first drives unless only the
/// second can without a defect or a broken constraint.
///
/// Where a dyad is a family: every pair of its choices is judged, of the best that differ by more
/// than a fifth of the extent (of the longest link, where the body's origin stands still) four for
/// each of `count` are improved by steps along the families, halved down to 1e-4 of the first, and
/// of results closer than a twentieth the better is kept. The same problem always gives the same
/// pairs. Once `deadline` is reached, what was found until then.
RankedPairs ranked_pairs(const MotionProblem& problem, const DyadPairChoices& options, int count,
                         const Deadline& deadline);

}  // namespace cognate::problems
