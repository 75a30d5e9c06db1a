/// @file Paths of chains that mind their tolerances least.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "problems/chain/problem.hpp"
#include "problems/chain/search.hpp"
#include "problems/search/robust.hpp"

namespace cognate::problems {

/// The design that a minimum is, in the file's unit; empty where it breaks a constraint.
using VerifiedChain = std::function<std::optional<Design>(const ChainMinimum& found)>;

/// The search for chains that mind their tolerances least, from minima of `spaces` or of narrower
/// ones of the same topologies. Minima that break a constraint are no starts. What is passed must
/// outlive the task.
RobustTask robust_chain_task(const ChainPathProblem& problem, const TargetScale& scale,
                             const std::vector<ScaledChain>& spaces,
                             const std::vector<ChainMinimum>& minima,
                             const VerifiedChain& verified);

}  // namespace cognate::problems
