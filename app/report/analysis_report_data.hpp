/// @file What the report page of an analysis shows beside the result document, as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "problems/evaluation/result.hpp"

namespace cognate::app {

/// The columns, landmarks and quantities of `result`, and the motion and the shapes of the
/// mechanism's bodies for drawing. Angles are in degrees. Numbers that are only drawn are rounded
/// to seven significant digits; where the mechanism does not close they are null.
nlohmann::ordered_json analysis_report_data(const problems::AnalysisProblem& problem,
                                            const problems::AnalysisResult& result);

}  // namespace cognate::app
