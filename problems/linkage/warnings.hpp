/// @file What no engineer would build though it meets the letter of a file.
#pragma once

#include <optional>
#include <span>

#include "problems/basics/length_unit.hpp"
#include "problems/linkage/cycle/operation.hpp"
#include "problems/linkage/result.hpp"
#include "problems/toml/table_reader.hpp"
#include "problems/toml/table_writer.hpp"

namespace cognate::problems {

/// Where what a linkage is designed for lies, and how large it is, in the file's unit.
struct TargetExtent {
  Vec2d centre;     ///< the centroid of points
  double size = 0;  ///< twice the greatest distance of a point from it: a diameter
};

/// That of points; empty where they are one point.
std::optional<TargetExtent> extent_of(std::span<const Vec2d> points);

/// Adds to each design of `result` that meets every constraint its warnings, and to those of the
/// result the same in general terms with the numbers of the designs. It is warned of
/// - a transmission angle that falls below `limits` in the motion, and more strongly of one within
///   5° of a dead point, where forces are a dozen times those transmitted;
/// - a link (or a point on one) farther out, or a fixed pivot farther away, than so many times the
///   target is large; a target that was placed is as large as it was placed;
/// - a crank so many times as long as another link;
/// - of four-bars whose target has no size, links that are so unlike, and of others links a hundred
///   times as long as another;
/// - a four-bar a thousandth of its longest link or less from a change point, yet not on it:
///   clearances and the tolerances of the lengths then decide which links turn fully;
/// - an exact synthesis whose equations have a condition number beyond the limit.
void add_warnings(const std::optional<TargetExtent>& target, const WarningLimits& limits,
                  Result& result);

/// Adds the note of `unit_notes` (basics/unit_notes.hpp), the best design being what is long, where
/// `operation` has masses, loads or gravity.
void note_units(const Operation& operation, std::optional<LengthUnit> unit, Result& result);

namespace reading {

/// `[warnings]`.
WarningLimits read_warnings(TableReader& document);
TableWriter warnings_writer(const WarningLimits& limits);

}  // namespace reading

}  // namespace cognate::problems
