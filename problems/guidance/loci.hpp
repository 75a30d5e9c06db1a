/// @file What a body guidance leaves free, drawn: Burmester's curves and the poles.
#pragma once

#include "problems/guidance/problem.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems {

/// Two poses: the pole, and for each moving pivot given the bisector of its positions. Three: the
/// pole triangle. Four: the "centre-point curve" and the "circle-point curve" (at the first pose),
/// and a family for each branch of theirs. Nothing for five.
void add_motion_loci(const MotionProblem& problem, Result& result);

}  // namespace cognate::problems
