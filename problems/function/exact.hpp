/// @file Function generation by exact synthesis.
#pragma once

#include "problems/function/problem.hpp"
#include "problems/function/samples.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// All mechanisms through the precision points, feasible ones first. Where fewer conditions are
/// requested than there are unknowns, the best of the family that is left, and where that depends
/// on one number the family itself. An output that turns by the input's own angle is a
/// parallelogram's. `notes` name a degenerate system, solutions that are no
/// mechanism or complex, directions that come out turned by 180°, and how good numerical
/// derivatives are.
Result solve_exactly(const FunctionProblem& problem, const Deadline& deadline);

/// The best designs of the family that is left by one or two conditions fewer than unknowns. The
/// starts left free are sampled (a start angle over half a turn, which the other half repeats, or
/// within its bounds; a start displacement over the whole line by its tangent) and the best samples
/// are refined along the family. Better is what violates less, then by `best_by`.
///
/// A family on one number is among `families`, a table for each real solution.
Result solve_exact_family(const FunctionProblem& problem, const FunctionSamples& wanted,
                          const Deadline& deadline);

/// Takes each four-bar of `result`, through Chebyshev's points, to level peaks of its structural
/// error (see synthesis/exact/respacing.hpp) and puts the designs in order of their greatest error.
/// Those whose peaks cannot be levelled stay as good as they were, or better; `notes` name them.
void level_peaks(const FunctionProblem& problem, const FunctionSamples& wanted, Result& result);

/// Links longer than so many times the shortest are taken for the limit in which a slider takes
/// their place.
inline constexpr double kLimitingRatio = 1e3;

/// Whether the longest link of `design` is more than `kLimitingRatio` times the shortest.
bool is_limiting(const Design& design);

/// Adds sentences on the designs of `result`, in the order in which they stand there: which have a
/// start turned by 180° against the one given, which do not close over the whole range, and which
/// are at the limit of long links or near it.
void note_designs(const FunctionSamples& wanted, Result& result);

}  // namespace cognate::problems
