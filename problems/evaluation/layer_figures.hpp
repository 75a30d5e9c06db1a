/// @file The layers of an analysed mechanism's links.
#pragma once

#include "analysis/mechanism/assembly_ranges.hpp"
#include "problems/evaluation/problem.hpp"
#include "problems/evaluation/result.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// Sets `result.layers` and adds their number to the quantities, where `problem` has layers and the
/// mechanism can be assembled on `motion`; else, or where time or links do not allow it, a note.
void add_layers(const AnalysisProblem& problem, const AssemblyRanges& motion,
                const Deadline& deadline, AnalysisResult& result);

}  // namespace cognate::problems
