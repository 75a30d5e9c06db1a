/// @file What `cognate analyze` prints: the facts of a motion, its landmarks, and the work done.
#pragma once

#include <string>

#include "problems/analysis/analysis_result.hpp"

namespace cognate::app {

/// One line: the title, the mechanism's type, and its drive.
std::string describe(const problems::AnalysisProblem& problem);

/// A heading, the status in words, the facts and the landmarks as tables, the notes, and the time.
/// With `colour`, ANSI colours mark the status.
std::string analysis_table(const problems::AnalysisProblem& problem,
                           const problems::AnalysisResult& result, bool colour);

}  // namespace cognate::app
