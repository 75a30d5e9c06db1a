/// @file Whether washers, heads and nuts have room.
#pragma once

#include <string>
#include <vector>

#include "app/export/parts/link_parts.hpp"
#include "app/export/parts/part_layers.hpp"

namespace cognate::app {

/// A note on all washers between layers, heads and nuts that meet a part, a pin or one another
/// somewhere on the motion: the head below the lowest part of its pin, the nut above the highest,
/// each in as many layers as it is high. None where their diameters are not chosen.
std::vector<std::string> screw_room_notes(const PartMotion& moving, const LinkParts& made,
                                          const PartLayers& layers, const PartOrder& order);

}  // namespace cognate::app
