/// @file A straight-line solution as a design, measured by the analysis kernel.
#pragma once

#include "problems/linkage/result.hpp"
#include "problems/straight_line/problem.hpp"
#include "synthesis/exact/straight_line/contact_search.hpp"

namespace cognate::problems {

/// The design with its constraints checked and its quantities: "contact_points" (9: straight to the
/// eighth order), "straight_length_at_0_001" and "…_0_01" (the longest segment about the position
/// with δ/L at most so much, see analysis/coupler_curve/straightness.hpp), for each its
/// "deviation_…", "crank_from_deg_…", "crank_to_deg_…", "direction_deg_…" and
/// "speed_variation_…"; "straight_length_over_longest_link". A value that does not exist is left
/// out.
Design straight_line_design(const StraightLineProblem& problem,
                            const synthesis::StraightLineSolution& solution);

/// The straight length at 0.1 %, by which designs are sorted.
double straight_length(const Design& design);

}  // namespace cognate::problems
