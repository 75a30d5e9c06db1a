/// @file The global search for motion generation by least squares.
#pragma once

#include <string>
#include <vector>

#include "problems/deadline.hpp"
#include "problems/motion_model.hpp"
#include "problems/motion_problem.hpp"
#include "problems/result.hpp"
#include "synthesis/optimise/solver.hpp"

namespace cognate::problems {

/// A local minimum of a scaled motion problem.
struct MotionMinimum {
  MotionForm form;
  std::string origin;  ///< of its start
  synthesis::Solution solution;
};

/// The minima that `known` pairs of the scaled problem and `starts` starts lead to, best first, feasible ones before others; equal for any
/// number of threads. All starts are explored with few iterations of Gauss–Newton, of long lists of
/// poses over a part of them; the best different ones are brought to convergence, and the best of
/// these finished by `backend` where it is another. Counts what was done in `work`.
std::vector<MotionMinimum> search_motions(const MotionProblem& scaled,
                                          const std::vector<DyadPair>& known, int starts,
                                          synthesis::Backend backend, double tolerance,
                                          const Run& run, const Deadline& deadline, Work& work);

}  // namespace cognate::problems
