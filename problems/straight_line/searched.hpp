/// @file A stretch that a search found, as a design measured by the analysis kernel.
#pragma once

#include "problems/linkage/result.hpp"
#include "problems/straight_line/problem.hpp"
#include "problems/straight_line/search.hpp"

namespace cognate::problems {

/// What the measured stretch of a design is, for sorting and for tables.
struct StretchMeasures {
  double length = 0;
  double deviation = 0;
  double size_over_length = 0;
};

/// The design with its constraints checked: those of linkages, `target.*`, `crank_range_deg`,
/// `size_over_length_max` and `speed_variation_max`. Facts: "straight_length", "deviation",
/// "deviation_relative", "crank_from_deg", "crank_to_deg", "direction_deg", "speed_variation",
/// "size_over_length" (largest dimension of a link, the coupler's with its point, over the length),
/// "straight_length_over_longest_link" and "straight_length_over_box" (the diagonal of the box
/// along the line that holds both moving pivots over the stretch). `found` is in the file's unit.
Design searched_design(const StraightLineProblem& problem, const FoundStretch& found);

StretchMeasures measures_of(const Design& design);

/// What a check of the stretch allows, relative: its line is fitted by the strip alone, in which
/// the length is one of the second order of the deviation.
inline constexpr double kStretchTolerance = 1e-6;

}  // namespace cognate::problems
