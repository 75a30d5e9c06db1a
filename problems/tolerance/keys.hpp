/// @file The keys of `[tolerance]`, for readers and `cognate list`.
#pragma once

#include <string_view>

namespace cognate::problems::reading {

struct ToleranceKey {
  std::string_view name, meaning;
};

inline constexpr std::string_view kToleranceTable = "tolerance";

inline constexpr std::string_view kLengthTolerance = "length", kPivotTolerance = "pivots",
                                  kGrade = "grade", kPinClearance = "clearance",
                                  kDistribution = "distribution", kSampleCount = "samples",
                                  kYield = "yield", kJudged = "of", kAllocate = "allocate";

inline constexpr ToleranceKey kToleranceKeys[] = {
    {kLengthTolerance,
     "of every length, offset and coordinate of a point that is not named below: 0.1 (plus or "
     "minus), {plus, minus}, or a grade"},
    {"DIMENSION",
     "likewise of one: crank, coupler, rocker, frame, offset, coupler_point; of a "
     "chain a body's or point's name; of a cam base_radius, roller_radius..."},
    {kPivotTolerance, "of each coordinate of a fixed pivot; the frame's length then follows"},
    {kGrade,
     "the tolerance of lengths by a standard: IT1 to IT18 of ISO 286 (evenly about the "
     "nominal), or f, m, c, v of ISO 2768-1"},
    {kPinClearance, "{A = 0.02, C = 0.03}: radial clearance of pins, by joint"},
    {kDistribution, "normal (default; the tolerance is three standard deviations) or uniform"},
    {kSampleCount, "of the Monte Carlo, to 10000000 (default 100000; 0: none)"},
    {kYield, "{max_error = 0.3}: what counts as good; of angles max_error_deg"},
    {kJudged, "of an analysis: the point that is judged (default: the output)"},
    {kAllocate,
     "{limit = 0.3, by = \"worst-case\" (default) or \"rss\", cost = {crank = 2}}: the "
     "tolerances of least cost sum cost/t that keep the error within the limit; of "
     "angles limit_deg"}};

}  // namespace cognate::problems::reading
