/// @file Designs that are known as starts of a search.
#pragma once

#include <vector>

#include "problems/chain/search.hpp"

namespace cognate::problems {

/// Those of `known` that are of a topology of `chains`, their dimensions within its bounds, with
/// crank angles in order.
std::vector<ChainMinimum> known_starts(const std::vector<Design>& known,
                                       const std::vector<ScaledChain>& chains,
                                       const TargetScale& scale);

}  // namespace cognate::problems
