/// @file What the report page shows beside the result document, as JSON.
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "problems/basics/range.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::app {

/// `target`, limits of the transmission angle under `transmission_limits_deg` ([min, max] or null),
/// under `designs`, for each design, its sampled motion and what it has `reached` at the targets,
/// and the `loci` and `families` of the synthesis. Rounded to seven significant digits where it is
/// only drawn.
nlohmann::ordered_json report_data(
    const problems::Result& result, const nlohmann::ordered_json& target,
    const std::optional<problems::Range>& transmission_limits,
    const std::function<nlohmann::ordered_json(const problems::Design& design)>& reached);

/// Significant digits of numbers that are only drawn.
constexpr int kDrawnDigits = 7;

/// `x` to `digits` significant digits.
double round_to_digits(double x, int digits);

}  // namespace cognate::app
