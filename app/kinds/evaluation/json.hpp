/// @file An analysis and its result as JSON.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <tl/expected.hpp>

#include "problems/evaluation/result.hpp"

namespace cognate::app {

/// The document `cognate-result/1` of an analysis, as `schema/cognate-result-1.schema.json`
/// describes. `designs` holds the mechanism of the file, its origin `given`, with the drive's
/// position at each row (`crank_deg`, or `slide` for a driving slider) and the facts of its motion
/// as `metrics`; `analysis` holds the columns (null where the mechanism cannot be assembled) and
/// the landmarks.
///
/// The error says which number was NaN or infinite: no such document may be written.
tl::expected<nlohmann::ordered_json, std::string> result_document(
    const problems::AnalysisProblem& problem, const problems::AnalysisResult& result,
    std::uint64_t seed);

}  // namespace cognate::app
