/// @file The straight segments of a linkage whose dimensions are all known.
#pragma once

#include <cstddef>
#include <vector>

#include "problems/straight_line/segment.hpp"

namespace cognate::problems {

/// Segments of the coupler curve of `linkage` (its dimensions, assembly and place) from which those
/// that `problem` asks for, in the same unit, are reached: of the length given those that are the
/// best of their neighbours, else the longest whose samples lie within `loose` times the deviation
/// allowed. From all crank ranges; at most `most`, best first; none where the curve has none.
std::vector<LinkageSegment> scanned_segments(const StraightLineProblem& problem,
                                             const LinkageSegment& linkage, std::size_t most,
                                             double loose = 1.5);

}  // namespace cognate::problems
