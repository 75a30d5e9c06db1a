/// @file A linkage with the segment of its coupler curve that is to be straight, as the search
/// varies it.
#pragma once

#include <optional>

#include "analysis/linkage/four_bar.hpp"
#include "problems/straight_line/motion.hpp"
#include "problems/straight_line/problem.hpp"

namespace cognate::problems {

/// Angles of crank and line count from the frame's direction (`straight_line_motion.hpp`); the line
/// is directed as the crank's angle grows.
struct LinkageSegment {
  MechanismType type = MechanismType::four_bar;
  Assembly assembly = Assembly::open;
  CouplerDimensions<double> dimensions;
  double centre = 0;  ///< of the crank's range
  double reach = 0;   ///< half that range, positive
  double line = 0;    ///< direction of the line
  double height = 0;  ///< of the line: cross(direction, P)
  double length = 0;
  Vec2d pivot_a;
  double frame_angle = 0;

  double from() const { return centre - reach; }
  double to() const { return centre + reach; }
};

/// The largest dimension of a link, the coupler's counted with its point: the greatest of the
/// links, BP and CP.
double largest_dimension(const LinkageSegment& segment);

/// That over the length of the segment.
inline double size_over_length(const LinkageSegment& segment) {
  return largest_dimension(segment) / segment.length;
}

/// Whether two segments are one, or the mirror image of it in the frame, to `tolerance` in lengths
/// over the longest, and in angles to 30 times that, of half a radian at most.
bool same_segment(const LinkageSegment& a, const LinkageSegment& b, double tolerance);

/// The same figure `factor` times as large.
LinkageSegment enlarged(LinkageSegment segment, double factor);

/// Puts line, height and length where the curve between the ends has its best line, and returns the
/// deviation from it. Empty where the linkage does not close all the way, or the segment has no
/// length.
std::optional<double> fit_line(LinkageSegment& segment);

/// The problem's lengths divided by `unit`. Places count from the middle of the line where it has
/// ends.
StraightLineProblem in_unit(StraightLineProblem problem, double unit);

/// The same with the pivot's place, from the unit of a search to that of the file; of a line that
/// has ends it still counts from their middle.
LinkageSegment in_file_unit(LinkageSegment segment, double unit);

/// Whether something fixes the linkage's scale other than the length of the segment: a dimension
/// given, a bound of one, or, where the line itself has no place, a place of a pivot.
bool has_scale(const StraightLineProblem& problem);

}  // namespace cognate::problems
