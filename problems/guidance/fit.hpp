/// @file The global search for motion generation by least squares.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problems/guidance/model.hpp"
#include "problems/guidance/problem.hpp"
#include "problems/linkage/result.hpp"
#include "problems/search/statistics.hpp"
#include "synthesis/optimise/solver.hpp"

namespace cognate::problems {

/// A local minimum of a scaled motion problem.
struct MotionMinimum {
  MotionForm form;
  std::string origin;  ///< of its start
  synthesis::Solution solution;
};

struct MotionSearchResult {
  std::vector<MotionMinimum> minima;  ///< best first, feasible ones before others
  SearchStatistics statistics;
};

/// Minima of a scaled problem; equal for any number of threads. Starts, beside the `known`
/// pairs `starts` of them or until more promise nothing new, are explored with few iterations of
/// Gauss–Newton, of long lists of poses over a part of them; the best different ones are brought to
/// convergence, and the best of these finished by `solver` where it is another. Counts what was
/// done in `work`.
MotionSearchResult search_motions(const MotionProblem& scaled, const std::vector<DyadPair>& known,
                                  std::optional<int> starts, synthesis::Solver solver,
                                  double tolerance, const Run& run, const Deadline& deadline,
                                  Work& work);

}  // namespace cognate::problems
