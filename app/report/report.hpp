/// @file The report: one HTML page that shows a result.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "problems/cam/result.hpp"
#include "problems/evaluation/result.hpp"
#include "problems/gear/result.hpp"
#include "problems/kinds.hpp"
#include "problems/linkage/result.hpp"
#include "problems/machine/result.hpp"

namespace cognate::app {

/// A whole HTML page that opens from disk and loads nothing: `result_document` (the
/// `cognate-result/1` document of `result`, embedded as it is but for loci that would make the page
/// too large), the targets of `problem`, and the motion of each design, sampled by the analysis
/// kernel. Text of the user's cannot become markup.
std::string report_html(const nlohmann::ordered_json& result_document,
                        const problems::Problem& problem, const problems::Result& result);

/// The page of an analysis, likewise: the mechanism in motion, sampled by the analysis kernel, and
/// the columns, landmarks and facts of `result`. Rows are thinned where there are more than can be
/// drawn. `result_document` is embedded as it is, but the columns of its `analysis`, and with them
/// the drive's positions in its design, are left out where the page would become too large.
std::string report_html(const nlohmann::ordered_json& result_document,
                        const problems::AnalysisProblem& problem,
                        const problems::AnalysisResult& result);

/// The page of a cam, likewise: the cam turning and its follower, what is plotted over the turn,
/// and the facts of each design. A list of very many motion segments is left out of
/// `result_document`.
std::string report_html(const nlohmann::ordered_json& result_document,
                        const problems::CamProblem& problem, const problems::CamResult& result);

/// The page of a machine, likewise: the mechanism at its true varying speed, what is plotted of
/// each motion, and the facts. The tables of the motions are left out of `result_document` where
/// the page would become too large.
std::string report_html(const nlohmann::ordered_json& result_document,
                        const problems::MachineProblem& problem,
                        const problems::MachineResult& result);

/// The page of a gear, likewise: the rack that cuts it, and what is plotted over the radius.
std::string report_html(const nlohmann::ordered_json& result_document,
                        const problems::GearProblem& problem, const problems::GearResult& result);

/// The page of a gear pair, likewise: the gears turning in mesh (of bevel gears the virtual ones,
/// of a worm its middle plane), the path of contact and what is plotted along it.
std::string report_html(const nlohmann::ordered_json& result_document,
                        const problems::GearPairProblem& problem,
                        const problems::GearPairResult& result);

}  // namespace cognate::app
