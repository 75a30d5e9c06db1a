/// @file The keys of `[target]` and `[constraints]` of legs.
#pragma once

#include "problems/leg/problem.hpp"
#include "problems/toml/keys.hpp"

namespace cognate::problems::reading {

/// Powers of lengths must be numbers too.
inline constexpr NumberRule kStride{[](double x) { return x >= 1e-50 && x <= 1e50; },
                                    "a length from 1e-50 to 1e50"};
inline constexpr NumberRule kFlatness{[](double x) { return x >= 1e-3 && x <= 1; },
                                      "a ratio from 0.001 to 1"};
inline constexpr NumberRule kSlowestFoot{[](double x) { return x >= -10 && x < 1; },
                                         "a multiple of the mean speed from -10 to below 1"};
inline constexpr NumberRule kFastestFoot{[](double x) { return x > 1 && x <= 100; },
                                         "a multiple of the mean speed above 1, up to 100"};
inline constexpr NumberRule kNearFactor{[](double x) { return x > 1 && x <= 100; },
                                        "a factor above 1, up to 100"};

inline constexpr Key<LegTarget> kLegTargetKeys[] = {
    key<&LegTarget::duty>("target.duty",
                          "share of the turn in which the foot stands (default 0.5), or the least",
                          kDutyFactor),
    key<&LegTarget::stride>("target.stride", "extent of the foot's path along the ground in stance",
                            kStride),
    key<&LegTarget::height_min>("target.height_min", "the least step height", kLength),
    key<&LegTarget::height_max>("target.height_max", "the most", kLength),
    key<&LegTarget::flatness_max>("target.flatness_max",
                                  "the most height over the ground in stance, over the stride",
                                  kFlatness),
    key<&LegTarget::objective>(
        "target.objective",
        "\"flatness\" (default): the least at the duty given; \"duty\": the most within "
        "flatness_max")};

inline constexpr Key<LegConstraints> kLegConstraintKeys[] = {
    key<&LegConstraints::foot_speed_min>(
        "constraints.foot_speed_min",
        "the least speed of the foot in stance over its mean; below 0 it may step back",
        kSlowestFoot),
    key<&LegConstraints::foot_speed_max>("constraints.foot_speed_max", "the most", kFastestFoot)};

inline constexpr Key<LegProblem> kLegMechanismKeys[] = {
    key<&LegProblem::near>("mechanism.near",
                           "\"klann\", \"jansen\": the most factor between links, sides of plates, "
                           "distances from the crank's pivot and the published ones",
                           kNearFactor)};

}  // namespace cognate::problems::reading
