/// @file Every kind of problem: the one header that names them all.
#pragma once

#include <variant>

#include "problems/cam/problem.hpp"
#include "problems/evaluation/problem.hpp"
#include "problems/function/problem.hpp"
#include "problems/gear/problem.hpp"
#include "problems/guidance/problem.hpp"
#include "problems/machine/problem.hpp"
#include "problems/path/problem.hpp"
#include "problems/quick_return/problem.hpp"
#include "problems/straight_line/problem.hpp"

namespace cognate::problems {

/// Whatever design of a linkage a file may ask for.
using Problem = std::variant<PathProblem, FunctionProblem, MotionProblem, QuickReturnProblem,
                             StraightLineProblem>;

/// Whatever a file may ask for: the design of a linkage, the analysis of a mechanism, a cam, a gear
/// or a pair of them, or what a machine does.
using Task = std::variant<Problem, AnalysisProblem, CamProblem, GearProblem, GearPairProblem,
                          MachineProblem>;

}  // namespace cognate::problems
