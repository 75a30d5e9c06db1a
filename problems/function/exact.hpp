/// @file Function generation by exact synthesis.
#pragma once

#include "problems/function/problem.hpp"
#include "problems/linkage/deadline.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// All mechanisms through the precision points, feasible ones first. Where fewer conditions are
/// requested than there are unknowns, the best of the family that is left, and where that depends
/// on one number the family itself. An output that turns by the input's own angle is a
/// parallelogram's. `notes` name a degenerate system, solutions that are no
/// mechanism or complex, directions that come out turned by 180°, and how good numerical
/// derivatives are.
Result solve_exactly(const FunctionProblem& problem, const Deadline& deadline);

}  // namespace cognate::problems
