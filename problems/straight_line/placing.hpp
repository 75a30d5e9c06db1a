/// @file Where a linkage stands in the plane where its line has ends there.
///
/// A rigid motion takes the line that a linkage traces to the line between the ends. It can be
/// traced from either end, and by the linkage or its mirror image: four places in all.
#pragma once

#include "analysis/coupler_curve/straightness.hpp"
#include "problems/straight_line/segment.hpp"

namespace cognate::problems {

/// Whether the line has ends and something limits the linkage's place, which is then varied by the
/// search. Without such limits a linkage is moved onto the line once it is found.
bool limits_place(const StraightLineProblem& problem);

/// The linkage with the middle of its line in the middle between the ends, in the one of the four
/// places that violates the limits of the place least. `segment` has its line; one that does not
/// close at its ends stays as it is.
LinkageSegment placed(const StraightLineProblem& problem, const LinkageSegment& segment);

/// How far a linkage is outside the limits of its place: the largest distance of a pivot from where
/// it may be, or angle of the frame, in radians.
double place_violation(const StraightLineProblem& problem, const LinkageSegment& segment);

/// Whether pivots are in the same places, to `tolerance` in lengths over the longest.
bool same_place(const LinkageSegment& a, const LinkageSegment& b, double tolerance);

/// A segment in the file's unit where it stands in the file's plane: a place that the search varied
/// counts from the middle of the ends, any other linkage is moved onto the line.
LinkageSegment in_file_plane(const StraightLineProblem& problem, LinkageSegment segment);

/// The part of a path from `from` to `to`: against the line through the ends, directed as the path
/// goes, where the problem has them, else against its own best line.
StraightSegment measured(const StraightLineProblem& problem, const Path& path, double from,
                         double to);

/// The largest distance, along the line, of the foot of an end of the path from the end of the line
/// that belongs to it. The problem has ends.
double distance_from_ends(const StraightLineProblem& problem, const Path& path,
                          const StraightSegment& segment);

}  // namespace cognate::problems
