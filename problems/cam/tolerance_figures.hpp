/// @file What tolerances of its dimensions do to the follower of a cam.
#pragma once

#include "problems/cam/problem.hpp"
#include "problems/cam/result.hpp"

namespace cognate::problems {

/// Sets the tolerances of every design, of many the first ten, and adds their figures to its
/// metrics. What is judged is the follower's place over the turn; the profile is as designed but
/// for the base radius, by which it is raised evenly. Of two contacts the first is looked at.
void add_tolerances(const CamProblem& problem, const Run& run, const Deadline& deadline,
                    CamResult& result);

}  // namespace cognate::problems
