/// @file Exact function generators where fewer conditions are requested than there are unknowns.
#pragma once

#include "problems/function/problem.hpp"
#include "problems/function/samples.hpp"
#include "problems/linkage/deadline.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// The best designs of the family that is left by one or two conditions fewer than unknowns. The
/// starts left free are sampled (a start angle over half a turn, which the other half repeats, or
/// within its bounds; a start displacement over the whole line by its tangent) and the best samples
/// are refined along the family. Better is what violates less, then by `best_by`.
///
/// A family on one number is among `families`, a table for each real solution.
Result solve_exact_family(const FunctionProblem& problem, const FunctionSamples& wanted,
                          const Deadline& deadline);

}  // namespace cognate::problems
