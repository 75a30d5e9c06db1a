/// @file Where along the drive a load begins or ceases to act.
#pragma once

#include <vector>

#include "analysis/mechanism/assembly_ranges.hpp"
#include "problems/evaluation/active_loads.hpp"
#include "problems/evaluation/problem.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// The stroke of the body of each load over the whole motion: the full turn of a crank, as far as
/// it closes, or the sweep of a driving slider. Its ends are where the body's velocity changes sign
/// or where the motion ends; those of a part of the motion once `deadline` is reached. Empty where
/// no load needs it.
std::vector<Stroke> load_strokes(const AnalysisProblem& problem, const Deadline& deadline);

/// The places of the drive over `assembly_ranges` at which a load with `rule` may begin or cease to
/// act whichever way the drive moves: the ends of `between` (of a drive that turns in every turn of
/// the course), where the loaded body turns back, and where that enters or leaves the part
/// of its stroke. Not ordered.
std::vector<double> load_breaks(const Mechanism<double>& mechanism,
                                const AssemblyRanges& assembly_ranges, const LoadRule& rule,
                                const Stroke& stroke);

}  // namespace cognate::problems
