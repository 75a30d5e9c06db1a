/// @file Dyads that guide a body through three poses.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "synthesis/exact/motion/dyad.hpp"

namespace cognate::synthesis {

/// The dyad with the moving pivot `in_body` (body axes): its fixed pivot is the centre of the three
/// positions of the pivot; pr where they are collinear. `pivot_at_rest`: two of them coincide, as
/// at a pole; the fixed pivots form a line, of which the dyad given is the point nearest the pivot.
DyadSolutions dyads_with_moving_pivot(std::span<const Pose, 3> poses, const Vec2d& in_body);

/// The dyad with the fixed pivot given: the same seen from the body, which takes the frame to move
/// by the inverse displacements; rp where the positions that the body sees are collinear.
DyadSolutions dyads_with_fixed_pivot(std::span<const Pose, 3> poses, const Vec2d& fixed);

/// The slider with a slide line along the unit vector `direction` of the fixed frame (pr).
DyadSolutions dyads_with_slide_direction(std::span<const Pose, 3> poses, const Vec2d& direction);

/// The block on a line of the body along the unit vector `direction`, body axes (rp).
DyadSolutions dyads_with_line_direction(std::span<const Pose, 3> poses, const Vec2d& direction);

/// The poles of the displacements 1→2, 2→3 and 3→1; empty where the pole is at infinity.
struct PoleTriangle {
  std::optional<Vec2d> p12, p23, p31;
};
PoleTriangle pole_triangle(std::span<const Pose, 3> poses);

}  // namespace cognate::synthesis
