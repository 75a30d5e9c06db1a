/// @file The keys of `[tolerance]` and the metrics of its figures, as data.
#pragma once

#include "app/documents/catalogue.hpp"
#include "problems/tolerance/keys.hpp"

namespace cognate::app {

inline constexpr auto kToleranceEntries = entries_of(problems::reading::kToleranceKeys);

inline constexpr std::string_view kToleranceMeaning =
    "how far the dimensions of what is made may be off";

/// Of the quantity that is judged; quantities that are not requested are absent.
inline constexpr Metric kToleranceMetrics[] = {
    {"tolerance_linear", "length", "worst case of first order over all positions"},
    {"tolerance_linear_deg", "deg", "the same of an angle"},
    {"tolerance_exact", "length", "exact worst case over the box of tolerances"},
    {"tolerance_exact_deg", "deg", "the same of an angle"},
    {"tolerance_rss", "length", "root sum of squares, greatest over the positions"},
    {"tolerance_rss_deg", "deg", "the same of an angle"},
    {"tolerance_sigma", "length", "standard deviation of the samples, likewise"},
    {"tolerance_sigma_deg", "deg", "the same of an angle"},
    {"tolerance_q99", "length", "99 of 100 samples err by no more at any position"},
    {"tolerance_q99_deg", "deg", "the same of an angle"},
    {"tolerance_clearance", "length", "what all pins with clearance can add, massless"},
    {"tolerance_clearance_deg", "deg", "the same of an angle"},
    {"tolerance_yield", "1", "share of samples within tolerance.yield"},
    {"tolerance_assembled", "1", "share of samples that can be assembled at every position"},
    {"tolerance_cost", "1", "of the allocated tolerances"}};

}  // namespace cognate::app
