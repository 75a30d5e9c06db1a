/// @file Blocks about the pins that run in slots.
#pragma once

#include <optional>
#include <string>

#include "app/export/parts/part_layers.hpp"

namespace cognate::app {

/// Why no block has the length and the width of `order.block`: narrower than its pin, wider than it
/// is long, or a slot for it as wide as the links. Empty where it can be, or none is wanted.
std::optional<std::string> impossible_block(const PartOrder& order);

/// The block of a slider: a rectangle about its joint along its first axis, with a bore for the
/// pin.
LinkPart block_part(int link, const LinkShape& slider, const PartOrder& order);

/// Notes that no slider has a block, or that the walls of blocks are thin.
void note_blocks(LinkParts& made, const PartOrder& order);

/// Why blocks in slots of one part cannot be: they meet somewhere on the motion, or the time was up
/// before that was known. The other parts of their layer keep from the part that has the slot, and
/// so from its block.
std::optional<std::string> blocks_meet(const PartMotion& moving, const LinkParts& made,
                                       const PartOrder& order);

/// The blocks as parts after the others, each in the layer of its slot.
void add_block_parts(LinkParts& made, PartLayers& layers);

}  // namespace cognate::app
