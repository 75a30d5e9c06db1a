/// @file The strokes that loads refer to.
#pragma once

#include <vector>

#include "problems/evaluation/active_loads.hpp"
#include "problems/evaluation/problem.hpp"
#include "problems/linkage/deadline.hpp"

namespace cognate::problems {

/// The stroke of the body of each load over the whole motion: the full turn of a crank, as far as
/// it closes, or the sweep of a driving slider. Its ends are where the body's velocity changes sign
/// or where the motion ends; those of a part of the motion once `deadline` is reached. Empty where
/// no load asks for it.
std::vector<Stroke> load_strokes(const AnalysisProblem& problem, const Deadline& deadline);

}  // namespace cognate::problems
