/// @file Chains whose dimensions lie on a raster.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "problems/chain/problem.hpp"
#include "problems/chain/search.hpp"
#include "synthesis/raster/raster.hpp"

namespace cognate::problems {

/// A chain on the raster, in the file's unit, its dimensions exactly those of the raster.
struct RasterChain {
  synthesis::ChainDesign design;
  std::vector<double> angles;               ///< of the crank at the targets; timed: the phase alone
  std::optional<CurvePlacement> placement;  ///< of a target that may be moved
};

struct RasterChainResult {
  std::vector<RasterChain> designs;  ///< best first
  synthesis::RasterResult search;
};

/// Whether a chain meets every constraint of the file. Called from many threads at once.
using ChainAcceptance = std::function<bool(const RasterChain& chain)>;

/// Searches the raster of `problem`, which has one topology, from designs of the same problem
/// without one; where the target may be moved, of `without_sizes` of it. Where it may not and
/// dimensions are free beside the raster, the best combinations are searched as problems of their
/// own too. Counts that in `work`.
RasterChainResult search_chain_raster(const ChainPathProblem& problem, const ScaledChain& scaled,
                                      const TargetScale& scale,
                                      const std::vector<ChainMinimum>& found,
                                      const ChainAcceptance& accepts, const Run& run,
                                      const Deadline& deadline, Work& work);

}  // namespace cognate::problems
