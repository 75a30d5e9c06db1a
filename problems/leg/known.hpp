/// @file Published legs, from which a search begins.
#pragma once

#include <optional>
#include <string_view>

#include "synthesis/chain/chain.hpp"

namespace cognate::problems {

/// The dimensions of a topology of `leg_topologies` as published, with the stride 1 and the crank's
/// pivot at the origin. "klann": Klann, US patent 6,260,862, its proportions. "jansen": the eleven
/// "holy numbers" of Theo Jansen, The Great Pretender, 010 Publishers 2007. Empty for others.
std::optional<synthesis::ChainDesign> known_leg(std::string_view topology);

}  // namespace cognate::problems
