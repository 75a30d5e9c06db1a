/// @file What `[tolerance]` of an analysis may name and judges.
#pragma once

#include "problems/evaluation/problem.hpp"
#include "problems/tolerance/read.hpp"

namespace cognate::problems {

/// The dimensions, turning joints and moving points of a mechanism.
reading::ToleranceScope tolerance_scope(const NamedMechanism& mechanism);

/// Whether what the tolerances of the problem are judged by is an angle: that of the output.
bool judges_angle(const AnalysisProblem& problem);

}  // namespace cognate::problems
