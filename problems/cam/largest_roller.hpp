/// @file A roller whose radius a file leaves free and no objective decides.
#pragma once

#include "analysis/cam/cam.hpp"
#include "problems/cam/problem.hpp"

namespace cognate::problems {

/// Whether the roller's radius is free and nothing that is requested gets better with it: it then
/// follows from the cam, as the largest that keeps every limit. (A large roller bears more and
/// turns more slowly.) Else it is a variable of the search.
bool frees_roller(const CamProblem& problem);

/// `problem` with such a roller as small as its bounds allow; itself where there is none.
CamProblem without_roller(CamProblem problem);

/// Gives `cam` that largest roller: within its bounds, where the file gives no upper one at most
/// 0.4 of the base radius and 0.8 of the pitch curve's least convex radius (Li & Xu 2011, chapter
/// 4). To rounding, by bisection on the limits themselves.
void enlarge_roller(const CamProblem& problem, cam::Cam& cam);

}  // namespace cognate::problems
