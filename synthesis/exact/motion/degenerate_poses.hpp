/// @file What guides a body through degenerate poses.
#pragma once

#include <span>

#include "synthesis/exact/motion/dyad.hpp"

namespace cognate::synthesis {

/// Example dyads for poses of the given status, as far as that has any: for a translation along a
/// circle two equal and parallel links, along a straight line a slider, else none; for turns about
/// one point the pin there, a link without length.
DyadSolutions degenerate_dyads(std::span<const Pose> poses, GuidanceStatus status);

}  // namespace cognate::synthesis
