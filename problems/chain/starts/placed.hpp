/// @file Designs of a path that may be moved and enlarged, put where the file's dimensions are.
#pragma once

#include <span>
#include <vector>

#include "problems/chain/placed_fit.hpp"
#include "problems/chain/search.hpp"

namespace cognate::problems {

/// `problem` with nothing given and nothing bounded but assemblies: as a chain that may be moved
/// itself, which is the same as moving its target.
ChainPathProblem without_sizes(const ChainPathProblem& problem);

/// Each design of `without_sizes` at several sizes, which the crank's range says (one where it is
/// given), and directions, its crank's pivot where the file has it or in the middle of its bounds;
/// the target is moved with it. Dimensions are within bounds, given ones as given, so that the
/// target no longer fits exactly.
std::vector<PlacedChain> placed_starts(const ScaledChain& scaled,
                                       std::span<const ChainMinimum> found);

}  // namespace cognate::problems
