/// @file Motions with some of their limits dropped, from which a search begins.
#pragma once

#include <vector>

#include "problems/guidance/problem.hpp"

namespace cognate::problems {

/// `problem` without one kind of its limits each (class, transmission angle, places of pivots,
/// lengths), and without all of these if they are several; empty if there are none. Where the
/// transmission angle is limited and the class is not, also as it is: see `confine` in fit.cpp.
std::vector<MotionProblem> relaxations(const MotionProblem& problem);

}  // namespace cognate::problems
