/// @file Chains drawn at random whose output nearly generates a function.
#pragma once

#include <optional>
#include <random>

#include "problems/chain_function/model.hpp"

namespace cognate::problems {

/// The best of many chains drawn with their crank's start. Seen from the output as it is to turn
/// about a pivot G of the frame, its joint F stands still, and the point E that carries it moves
/// along a circle about F: the nearest circle gives F and the length EF, many pivots G are tried.
/// Where the output is no such dyad, it is evaluated as drawn.
std::optional<ChainFunctionDesign> draw_chain_function(const ChainFunctionSpace& space,
                                                       std::mt19937_64& random);

}  // namespace cognate::problems
