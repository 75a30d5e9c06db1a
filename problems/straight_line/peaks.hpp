/// @file Where a segment strays between the positions at which it was fitted.
#pragma once

#include <optional>
#include <vector>

#include "problems/straight_line/segment.hpp"

namespace cognate::problems {

/// The places between nodes where the curve is farther from the line than at any of them, or,
/// where the change of speed is limited, faster or slower by more than a little of that. Nodes are
/// parts of the reach, from -1 to 1.
std::vector<double> peaks_beyond(const LinkageSegment& segment, const std::vector<double>& nodes,
                                 const std::optional<double>& variation);

}  // namespace cognate::problems
