/// @file Motion problems without some of their limits, from whose minima a search goes on.
#pragma once

#include <vector>

#include "problems/guidance/problem.hpp"

namespace cognate::problems {

/// `problem` without one kind of its limits each (class, transmission angle, places of pivots,
/// lengths), and without all of these if they are several; empty if there are none.
std::vector<MotionProblem> relaxations(const MotionProblem& problem);

}  // namespace cognate::problems
