/// @file A straight-line problem without method = "exact", from problem to designs.
#pragma once

#include "problems/linkage/result.hpp"
#include "problems/straight_line/problem.hpp"

namespace cognate::problems {

/// The best designs by the goal; where it names neither length nor deviation, the front of relative
/// deviation and size over length ("straight-line front" among the families), designs evenly along
/// it. The same for any number of threads.
Result search_straight_lines(const StraightLineProblem& problem, const Run& run);

}  // namespace cognate::problems
