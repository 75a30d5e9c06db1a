/// @file What the dyads of a body guidance are put together of.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "problems/guidance/dyad_choices.hpp"
#include "synthesis/exact/motion/dyad.hpp"

namespace cognate::problems {

/// `text` with a capital and a full stop.
std::string as_sentence(std::string_view text);

template <std::size_t Count>
std::span<const synthesis::Pose, Count> fixed_size(const std::vector<synthesis::Pose>& poses) {
  return std::span<const synthesis::Pose, Count>(poses.data(), Count);
}

/// Adds the dyads of allowed kinds to `options`, not to be moved; the others are noted.
void add_dyads(const MotionProblem& problem, const synthesis::DyadSolutions& found,
               DyadChoices& options);

/// A dyad that is the list `found`; `what` it is for, in a note where that is not all right.
DyadChoices listed(const MotionProblem& problem, const synthesis::DyadSolutions& found,
                   const std::string& what);

/// A parameter in (−1, 1) to the distance from the foot of a whole line, in extents.
double along(double parameter);

/// Adds what `options` has at a grid of `side` × `side` places from −1.5 to 1.5, off its axes (a
/// pivot at the body's origin itself is a common pole), each with the rest of `place`.
void add_grid(int side, const DyadPlace& place, const DyadPlace& step, DyadChoices& options);

/// The dyad of a pivot that the file gives, for two or three poses; `length` is that of its link.
DyadChoices dyad_of_pivot(const MotionProblem& problem, const Vec2d& pivot, bool moving,
                          const std::optional<double>& length);

/// The dyad where no pivot is given, for two or three poses: links where the file leaves the kinds
/// open; else all that it allows.
DyadChoices free_dyad(const MotionProblem& problem);

/// The dyad of three or more poses that are not turned against one another. Along a circle the body
/// depends on equal and parallel links, whose moving pivots may lie anywhere.
DyadChoices dyad_of_translation(const MotionProblem& problem);

}  // namespace cognate::problems
