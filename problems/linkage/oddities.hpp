/// @file What no engineer would build though it meets the letter of a file.
#pragma once

#include <optional>
#include <span>

#include "problems/basics/length_unit.hpp"
#include "problems/linkage/operation.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// Where what a linkage is designed for lies, and how large it is: the root of the mean squared
/// distance of points from their centroid, in the file's unit.
struct TargetExtent {
  Vec2d centre;
  double size = 0;
};

/// That of points; empty where they are one point.
std::optional<TargetExtent> extent_of(std::span<const Vec2d> points);

/// Adds to the notes which four-bars of `result` that meet every constraint, by their numbers,
/// - come within 5° of a dead point in their motion: forces there are a dozen times those
///   transmitted, and the output hardly follows;
/// - have a link more than a hundred times as long as the target is large, or a fixed pivot so far
///   away from it; a target that was placed is as large as it was placed;
/// - have a link more than a hundred times as long as another;
/// - lie a thousandth of their longest link or less from a change point, yet not on it: clearances
///   and the tolerances of the lengths then decide which links turn fully.
///
/// Without `target` the second is not asked. Transmission angles up to `noted`, of which a note of
/// the kind's own says more, are left out.
void note_oddities(const std::optional<TargetExtent>& target, Result& result, double noted = -1);

/// Adds the note of `unit_notes` (basics/unit_notes.hpp), the best design being what is long, where
/// `operation` has masses, loads or gravity.
void note_units(const Operation& operation, std::optional<LengthUnit> unit, Result& result);

}  // namespace cognate::problems
