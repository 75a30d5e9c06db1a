/// @file Where the mechanism cannot be assembled, and why.
#pragma once

#include <string>
#include <vector>

#include "problems/evaluation/sweep.hpp"

namespace cognate::problems {

/// A sentence for each run of rows whose first open dyad is the same: the drive's range, the dyad,
/// and the distance that its links cannot span where it is worst; or that its position there is not
/// determined. Some sentences only where there are many such runs.
std::vector<std::string> open_row_notes(const AnalysisProblem& problem, const Sweep& sweep);

}  // namespace cognate::problems
