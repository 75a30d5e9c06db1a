/// @file A gear, or what is asked of a pair, in a line.
#pragma once

#include <string>

#include "problems/gear/problem.hpp"

namespace cognate::app {

/// The title, the kind of gearing, and teeth and module, or what of them is free.
std::string describe(const problems::GearProblem& problem);
std::string describe(const problems::GearPairProblem& problem);

}  // namespace cognate::app
