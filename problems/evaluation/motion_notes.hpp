/// @file What is to be said of a motion besides its quantities.
#pragma once

#include <string>
#include <vector>

#include "problems/evaluation/motion_summary.hpp"
#include "problems/evaluation/problem.hpp"

namespace cognate::problems {

/// That the drive crosses several ranges, and which quantities belong to which; that a stroke has
/// no end.
std::vector<std::string> motion_notes(const AnalysisProblem& problem, const MotionSummary& summary);

}  // namespace cognate::problems
