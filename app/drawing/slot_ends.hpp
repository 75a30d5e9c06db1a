/// @file How far blocks travel in their slots, to rounding.
#pragma once

#include "analysis/mechanism/followed_motion.hpp"
#include "app/drawing/link_shapes.hpp"

namespace cognate::app {

/// Moves the ends of all rails of `shown`, which are places at samples, on to where the blocks turn
/// back between them: each rail is then no shorter than the stroke, and longer only by rounding.
/// `motion` is of the same linkage over the same drive.
void reach_slot_ends(LinkShapes& shown, FollowedMotion<0>& motion);

}  // namespace cognate::app
