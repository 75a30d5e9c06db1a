/// @file Dyads that guide a body through five poses: Burmester's problem in closed form.
#pragma once

#include <span>

#include "synthesis/exact/motion/dyad.hpp"

namespace cognate::synthesis {

/// All dyads through five poses: none, two or four (one or three where two fall together), rr, pr
/// or rp. Status `found` or `none` for poses in general position; `coincident_poses`,
/// `translation`, `rotation` and `family` name what is degenerate, and dyads given with them are
/// examples. Allocates nothing.
DyadSolutions dyads_of_five_poses(std::span<const Pose, 5> poses);

}  // namespace cognate::synthesis
