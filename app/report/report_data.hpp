/// @file What the report page shows beside the result document, as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "problems/kinds.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::app {

/// The targets under `target`, limits of the transmission angle under `transmission_limits_deg`
/// ([min, max] or null), under `designs`, for each design, its sampled motion and what it reaches
/// at the targets, and the `loci` and `families` of the synthesis. Rounded to seven significant
/// digits where it is only drawn.
nlohmann::ordered_json report_data(const problems::Problem& problem,
                                   const problems::Result& result);

/// Significant digits of numbers that are only drawn.
constexpr int kDrawnDigits = 7;

/// `x` to `digits` significant digits.
double round_to_digits(double x, int digits);

}  // namespace cognate::app
