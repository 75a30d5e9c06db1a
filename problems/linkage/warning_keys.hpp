/// @file The keys of `[warnings]`.
#pragma once

#include "problems/linkage/linkage_limits.hpp"
#include "problems/toml/keys.hpp"

namespace cognate::problems::reading {

inline constexpr NumberRule kWarnedAngle{[](double x) { return x >= 0 && x <= 90; },
                                         "an angle in degrees from 0 to 90"};

inline constexpr Key<WarningLimits> kWarningKeys[] = {
    key<&WarningLimits::transmission_angle>("transmission_angle_deg",
                                            "designs whose transmission angle, or its supplement, "
                                            "falls below are warned of (default 30)",
                                            kWarnedAngle),
    key<&WarningLimits::link_over_target>(
        "link_over_target",
        "likewise with a link longer than so many times the target's diameter (default 10)",
        kRatio),
    key<&WarningLimits::pivot_over_target>(
        "pivot_over_target", "likewise with a fixed pivot so far from its centroid (default 10)",
        kRatio),
    key<&WarningLimits::link_ratio>("link_ratio",
                                    "likewise with the crank over the shortest other link, and "
                                    "where the target has no size with the longest over the "
                                    "shortest (default 20)",
                                    kRatio),
    key<&WarningLimits::condition>(
        "condition", "likewise with the condition number of an exact synthesis (default 1e4)",
        kRatio)};

}  // namespace cognate::problems::reading
