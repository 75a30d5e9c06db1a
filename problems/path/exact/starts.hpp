/// @file Starts of a path search from exact synthesis through nine of its points.
#pragma once

#include <vector>

#include "problems/linkage/result.hpp"
#include "problems/path/starts.hpp"

namespace cognate::problems {

/// Whether exact synthesis can help: the crank angles are free, no dimension is given and no length
/// limited (linkages through nine points are seldom small), and there are nine different points,
/// which are no samples of a closed curve.
bool has_exact_starts(const PathProblem& problem);

/// The sound linkages through nine of the points, spread over the list, which satisfy the problem's
/// constraints; crank angles at the other points lie evenly between those of their neighbours.
std::vector<PathStart> exact_starts(const PathProblem& problem, const Run& run,
                                    const Deadline& deadline);

}  // namespace cognate::problems
