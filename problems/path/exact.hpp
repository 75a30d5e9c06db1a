/// @file Path generation by exact synthesis: four-bars through every point and pose.
#pragma once

#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// Every four-bar of the real plane through the positions of a problem with method `exact`, the
/// sound ones first, where positions and given parts make as many conditions as a four-bar has
/// dimensions (eight beside the reference); else the best of a sample of the family that there is.
/// `quantities` count what was found, `notes` say it in words.
Result solve_exactly(const PathProblem& problem, const Run& run);

}  // namespace cognate::problems
