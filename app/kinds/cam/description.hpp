/// @file A cam problem in a line.
#pragma once

#include <string>

#include "problems/cam/problem.hpp"

namespace cognate::app {

/// The title, the follower, how many segments its motion has and what is free.
std::string describe(const problems::CamProblem& problem);

}  // namespace cognate::app
