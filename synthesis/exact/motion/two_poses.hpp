/// @file Dyads that guide a body through two poses.
///
/// The fixed pivots of a moving pivot lie on the perpendicular bisector of its two positions; the
/// moving pivots of a fixed pivot on that of the positions which the body sees it take.
#pragma once

#include <optional>
#include <span>

#include "synthesis/exact/motion/dyad.hpp"

namespace cognate::synthesis {

/// The fixed pivots that serve the moving pivot `in_body` (body axes): the perpendicular bisector,
/// in the fixed frame. Empty where the pivot does not move.
std::optional<Line> fixed_pivots_of(std::span<const Pose, 2> poses, const Vec2d& in_body);

/// The moving pivots that serve the fixed pivot: a line in body axes. Empty at the pole.
std::optional<Line> moving_pivots_of(std::span<const Pose, 2> poses, const Vec2d& fixed);

/// The dyad with the moving pivot `in_body` and its fixed pivot on `line`: the bisector meets the
/// line, or runs parallel to it (pr: the slide line is across the bisector), or is the line
/// (`same_line`). Where the pivot stands still: `pivot_at_rest`.
DyadSolutions dyads_with_fixed_pivot_on(std::span<const Pose, 2> poses, const Vec2d& in_body,
                                        const Line& line);

/// The dyad with the fixed pivot given and its moving pivot on `line`, in body axes; rp where the
/// two are parallel.
DyadSolutions dyads_with_moving_pivot_on(std::span<const Pose, 2> poses, const Vec2d& fixed,
                                         const Line& line);

/// The dyads of a link `length` > 0 long with the moving pivot `in_body`: two, one where the link
/// is half the pivot's way, `out_of_reach` where it is shorter.
DyadSolutions dyads_of_length(std::span<const Pose, 2> poses, const Vec2d& in_body, double length);

/// The slider that carries the moving pivot straight from one position to the other (pr).
DyadSolutions slider_of(std::span<const Pose, 2> poses, const Vec2d& in_body);

}  // namespace cognate::synthesis
