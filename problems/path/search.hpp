/// @file The global search for path generation: many screened starts, each brought to its minimum.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "problems/linkage/linkage_limits.hpp"
#include "problems/linkage/result.hpp"
#include "problems/path/model.hpp"
#include "problems/path/problem.hpp"
#include "problems/path/scale.hpp"
#include "problems/search/robust.hpp"
#include "problems/search/statistics.hpp"
#include "synthesis/optimise/solver.hpp"

namespace cognate::problems {

/// A local minimum of a scaled path problem.
struct PathMinimum {
  Assembly assembly = Assembly::open;
  bool clockwise = false;
  /// The class that the search kept to. Beside the file's own it is set where the transmission
  /// angle is limited and the crank of the start turns fully: the limits are then those of the full
  /// turn.
  std::optional<RequiredClass> confined_to;
  synthesis::Solution solution;
  bool from_exact = false;  ///< its start came from exact synthesis through nine of the points
};

/// The model of which `minimum` is a minimum.
PathModel model_of(const PathProblem& scaled, const PathMinimum& minimum);

struct PathSearchResult {
  std::vector<PathMinimum> minima;  ///< best first, feasible ones before others
  SearchStatistics statistics;
};

/// Minima of a scaled problem; equal for any number of threads. Starts are explored in SIMD lanes
/// until more of them promise nothing new, or as many as the file says; the best different minima
/// are brought to convergence under exact constraints by Gauss–Newton, and the best of these
/// finished by `solver` where it is another. In any order the minima of the same problem in order
/// are among the candidates. Counts what was done in `work`.
PathSearchResult search_paths(const PathProblem& scaled, synthesis::Solver solver, double tolerance,
                              const Run& run, const Deadline& deadline, Work& work);

/// The design that a four-bar in the file's unit is with its crank angles at the points (from the x
/// axis); empty where it breaks a constraint.
using VerifiedPath =
    std::function<std::optional<Design>(const FourBar& linkage, std::vector<double> crank_angles)>;

/// The search for paths that mind their tolerances least, from minima of `scaled`; it needs
/// `scale` to last. Without a start where no dimension has a tolerance, or no minimum is within
/// limits.
RobustTask robust_path_task(const PathProblem& problem, const PathProblem& scaled,
                            const PathScale& scale, const std::vector<PathMinimum>& minima,
                            const VerifiedPath& verified);

}  // namespace cognate::problems
