/// @file Starts of a path search, and their fits in SIMD lanes.
#pragma once

#include <span>

#include "problems/path/found.hpp"
#include "problems/path/starts.hpp"
#include "synthesis/lanes/path_fit.hpp"

namespace cognate::problems {

/// A start, before it is fitted, of a scaled problem.
PathFound placed(const PathProblem& problem, const PathStart& start);

/// Fits those of `all` that are valid in SIMD lanes; those confined to one class share one problem.
void fit_in_lanes(const PathProblem& problem, std::span<PathFound> all,
                  const synthesis::PathFitOptions& options);

}  // namespace cognate::problems
