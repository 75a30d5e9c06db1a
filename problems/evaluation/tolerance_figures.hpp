/// @file The tolerances of an analysed mechanism.
#pragma once

#include "problems/evaluation/problem.hpp"
#include "problems/evaluation/result.hpp"
#include "problems/evaluation/sweep.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// Sets `result.tolerance` and adds its figures to the quantities, where `problem` (with forces in
/// newtons) has tolerances. Of many rows at most 721 in equal steps are looked at.
void add_tolerances(const AnalysisProblem& problem, const Sweep& rows, const Run& run,
                    const Deadline& deadline, AnalysisResult& result);

}  // namespace cognate::problems
