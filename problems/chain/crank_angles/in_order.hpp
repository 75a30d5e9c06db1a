/// @file Where the crank of a chain is at points that are not timed, its dimensions being fixed.
#pragma once

#include <vector>

#include "problems/chain/scaled.hpp"

namespace cognate::problems {

/// Crank angles from which those of the points of `problem` can be refined, in either sense: at
/// steps of the crank, equal where it turns fully and else over its ranges, those with the least
/// sum of squared distances that pass all points in order, once round at most (dynamic programming,
/// Bellman 1957). The best, and the next best that begin elsewhere; empty where the chain can be
/// assembled at too few steps.
std::vector<std::vector<double>> ordered_angles(const ScaledChain& problem,
                                                const synthesis::ChainDesign& design);

}  // namespace cognate::problems
