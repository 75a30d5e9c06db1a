/// @file The keys of straight lines that hold one number or one range.
#pragma once

#include "problems/mechanism/quantity_rules.hpp"
#include "problems/straight_line/problem.hpp"
#include "problems/toml/keys.hpp"

namespace cognate::problems::reading {

inline constexpr NumberRule kRelativeDeviation{[](double x) { return x >= 1e-9 && x <= 0.1; },
                                               "a share of the length from 1e-9 to 0.1"};
inline constexpr NumberRule kSizeOverLength{[](double x) { return x >= 0.1 && x <= 100; },
                                            "a ratio from 0.1 to 100"};
inline constexpr NumberRule kVariation{[](double x) { return x >= 1e-6 && x <= 100; },
                                       "a share of the mean speed from 1e-6 to 100"};
/// A narrower range of the crank is no motion.
inline constexpr NumberRule kCrankRange{[](double x) { return x >= 1 && x <= 360; },
                                        "an angle in degrees from 1 to 360"};

/// `[target]` of a search.
inline constexpr Key<StraightLineGoal> kGoalKeys[] = {
    own_key<StraightLineGoal>(
        "target.ends",
        "[[x1, y1], [x2, y2]] of the line in the plane; then no length and no direction_deg"),
    key<&StraightLineGoal::length>(
        "target.length",
        "of the straight segment: deviation is minimised; with neither a Pareto front is searched",
        kLinkLength),
    key<&StraightLineGoal::deviation>(
        "target.deviation",
        "maximum distance from the line: length is maximised; both: size minimised", kLinkLength),
    key<&StraightLineGoal::deviation_relative>("target.deviation_relative",
                                               "or: that over the length", kRelativeDeviation),
    key<&StraightLineGoal::direction>("target.direction_deg", "of the line, either way along it",
                                      kAngle)};

/// `[constraints]` of a search in addition to those of linkages.
inline constexpr Key<SegmentConstraints> kSegmentKeys[] = {
    key<&SegmentConstraints::crank_range>("constraints.crank_range_deg",
                                          "search: [min, max] of the crank's turn over the segment",
                                          kCrankRange),
    key<&SegmentConstraints::size_over_length_max>(
        "constraints.size_over_length_max",
        "search: maximum dimension of a link, coupler point included, over the length (default 2)",
        kSizeOverLength),
    key<&SegmentConstraints::speed_variation_max>(
        "constraints.speed_variation_max", "search: (max - min)/mean of the speed along the line",
        kVariation)};

}  // namespace cognate::problems::reading
