/// @file Dyads nearest to many poses: circles and lines of least squared distance.
#pragma once

#include <optional>
#include <span>

#include "synthesis/exact/motion/dyad.hpp"
#include "synthesis/optimise/solver.hpp"

namespace cognate::synthesis {

/// How far a dyad is from guiding the body through the poses, as a sum of squares: the deviations
/// of the moving pivot's distance from the link's length (rr), of the moving pivot from the slide
/// line (pr), or of the fixed pivot from the body's line (rp).
double squared_misfit(const GuidingDyad& dyad, std::span<const Pose> poses);

/// The link of locally least misfit that is reached from `start`'s pivots. Empty where that
/// solver finds no value, or the pivots leave for infinity. `poses`: at least three.
std::optional<GuidingDyad> nearest_link(const GuidingDyad& start, std::span<const Pose> poses,
                                        const Options& options = {});

/// The slider and the block of least misfit: for a slide line of normal n the point of the body and
/// the line follow from a linear problem, n·(d + e m) = c, and what that leaves of n·d is least for
/// an eigenvector of a symmetric 2×2 matrix. There is one minimum. A block is a slider of the
/// inverse motion.
GuidingDyad nearest_slider(std::span<const Pose> poses);
GuidingDyad nearest_block(std::span<const Pose> poses);

/// The slider whose line has the direction given (a unit vector), and its best point.
GuidingDyad slider_along(std::span<const Pose> poses, const Vec2d& direction);
/// The block on a line of the body of the direction given (a unit vector, body axes).
GuidingDyad block_along(std::span<const Pose> poses, const Vec2d& direction);

}  // namespace cognate::synthesis
