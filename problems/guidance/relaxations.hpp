/// @file Motions with some of their limits or poses dropped, from which a search begins.
#pragma once

#include <cstddef>
#include <vector>

#include "problems/guidance/problem.hpp"

namespace cognate::problems {

/// `problem` without one kind of its limits each (class, transmission angle, places of pivots,
/// lengths), and without all of these if they are several; empty if there are none. Where the
/// transmission angle is limited and the class is not, also as it is: see `confine` in fit.cpp.
std::vector<MotionProblem> relaxations(const MotionProblem& problem);

/// The numbers of the poses over which starts are explored: even steps, first and last among them,
/// forty at most.
std::vector<std::size_t> in_even_steps(std::size_t count);

/// `problem` with the poses of these numbers.
MotionProblem only(const MotionProblem& problem, const std::vector<std::size_t>& numbers);

}  // namespace cognate::problems
