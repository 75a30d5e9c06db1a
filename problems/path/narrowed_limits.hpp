/// @file Paths whose points that are not timed exceed a limit of the transmission angle by little.
#pragma once

#include <optional>

#include "problems/linkage/result.hpp"
#include "problems/path/problem.hpp"
#include "problems/path/scale.hpp"

namespace cognate::problems {

/// A search that begins with one design alone, in the units of its problem.
struct NarrowedPath {
  PathProblem problem;
  Run run;
};

/// Whoever places points that are not timed may take the crank a little beyond where the search has
/// the limits of the transmission angle: the search from `design`, which exceeds them by little,
/// within limits narrowed by half as much again. Empty where the design breaks another constraint,
/// or these by more than three degrees. `scaled` is the design's problem by `scale`.
std::optional<NarrowedPath> narrowed(const PathProblem& scaled, const PathScale& scale,
                                     const Design& design, const Run& run);

}  // namespace cognate::problems
