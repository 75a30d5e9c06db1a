/// @file The whole motion of which an analysis may show a part.
#pragma once

#include "analysis/mechanism/assembly_ranges.hpp"
#include "problems/evaluation/problem.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// The motion from `start` to `end` of the drive; only a part of it once `deadline` is reached.
AssemblyRanges follow_until(const AnalysisProblem& problem, double start, double end,
                            const Deadline& deadline);

/// The whole turn of a crank or a floating link from the start of its sweep; a driving slider's
/// sweep.
AssemblyRanges whole_motion(const AnalysisProblem& problem, const Deadline& deadline);

}  // namespace cognate::problems
