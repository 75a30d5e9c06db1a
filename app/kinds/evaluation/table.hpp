/// @file What `cognate analyze` prints: the facts of a motion, its landmarks, and the work done.
#pragma once

#include <string>

#include "app/console/screen.hpp"
#include "problems/evaluation/result.hpp"

namespace cognate::app {

/// One line: the title, the mechanism's type, and its drive.
std::string describe(const problems::AnalysisProblem& problem);

/// A heading, the status in words, the facts and the landmarks as tables, the notes, and the time.
/// On a screen with colours these mark the status.
std::string analysis_table(const problems::AnalysisProblem& problem,
                           const problems::AnalysisResult& result, const Screen& screen);

}  // namespace cognate::app
