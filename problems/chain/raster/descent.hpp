/// @file The raster of a chain whose target may be moved, searched from neighbour to neighbour.
#pragma once

#include <span>
#include <vector>

#include "problems/chain/placed_fit.hpp"
#include "problems/chain/raster/axes.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// Puts the dimensions on the raster at the values of these numbers.
void set_numbers(const ChainAxes& axes, const synthesis::RasterNumbers& at,
                 synthesis::ChainDesign& design);

/// From each start rounded, the best neighbour, one or two dimensions by one value, until none is
/// better. What was reached, each once, best first: where continuous optima are many, sizes and
/// directions being free, their number counts more than where each lies.
std::vector<PlacedChain> descend_on_raster(const ScaledChain& scaled, const ChainAxes& axes,
                                           std::span<const PlacedChain> starts, int threads,
                                           const Deadline& deadline);

}  // namespace cognate::problems
