/// @file A segment that a search found, as a design measured by the analysis kernel.
#pragma once

#include "problems/basics/quantity_key.hpp"
#include "problems/linkage/result.hpp"
#include "problems/straight_line/problem.hpp"
#include "problems/straight_line/search.hpp"

namespace cognate::problems {

inline constexpr QuantityKey<double> kSegmentLengthKey{"straight_length"},
    kDeviationKey{"deviation"}, kSizeOverLengthKey{"size_over_length"},
    kSpeedVariationKey{"speed_variation"};
/// Crank angles between which the segment lies.
inline constexpr AngleKey kSegmentFromKey{"crank_from_deg"}, kSegmentToKey{"crank_to_deg"};
inline constexpr AngleKey kLineDirectionKey{"direction_deg"};

/// What the measured segment of a design is, for sorting and for tables.
struct SegmentMeasures {
  double length = 0;
  double deviation = 0;
  double size_over_length = 0;
};

/// The design with its constraints checked: those of linkages, `target.*`, `crank_range_deg`,
/// `size_over_length_max` and `speed_variation_max`. Facts: "straight_length", "deviation",
/// "deviation_relative", "crank_from_deg", "crank_to_deg", "direction_deg", "speed_variation",
/// "size_over_length" (largest dimension of a link, the coupler's with its point, over the length),
/// "straight_length_over_longest_link" and "straight_length_over_box" (the diagonal of the box
/// along the line that holds both moving pivots over the segment). `found` is in the file's unit
/// (`in_file_unit`) and comes to the line's place here; the deviation is from the line through
/// `target.ends` where the file has them.
Design searched_design(const StraightLineProblem& problem, const SegmentDesign& found);

SegmentMeasures measures_of(const Design& design);

/// What a check of the segment allows, relative: its line is fitted by the strip alone, in which
/// the length is one of the second order of the deviation.
inline constexpr double kSegmentTolerance = 1e-6;

}  // namespace cognate::problems
