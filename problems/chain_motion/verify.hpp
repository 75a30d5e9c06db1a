/// @file A design that guides a body, as the analysis kernel sees it.
#pragma once

#include "problems/chain/search.hpp"
#include "problems/chain_motion/problem.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// The path of the body's origin with all that holds of chains but the error, which is the motion's
/// own.
ChainPathProblem path_of(const ChainMotionProblem& problem);

/// Where the unit of the search is: that of the path.
TargetScale scale_of(const ChainMotionProblem& problem);

/// The design of a minimum. Its error is of places and, weighted, of angles; its quantities have
/// both apart, and how the body lies in its link. Infinite where the kernel does not reach a pose.
Design verified(const ChainMotionProblem& problem, const ChainMinimum& found);

}  // namespace cognate::problems
