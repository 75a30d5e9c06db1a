/// @file The global search for straight lines: starts, their minimax refinement, the best of those.
#pragma once

#include <string>
#include <vector>

#include "problems/linkage/result.hpp"
#include "problems/search/statistics.hpp"
#include "problems/straight_line/segment.hpp"
#include "problems/straight_line/starts.hpp"
#include "synthesis/optimise/solver.hpp"

namespace cognate::problems {

/// A local optimum. `segment` has its own best line: `fit_line`.
struct SegmentDesign {
  LinkageSegment segment;
  double objective = 0;  ///< δ/L, 1/L or size over length, less is better
  double violation = 0;  ///< of the limits, relative
  double promise = 0;    ///< of a refined start: an objective that refinement may reach
  std::string origin;    ///< the family of its start
  int hits = 1;          ///< how many starts have come here
};

struct SegmentSearchResult {
  std::vector<SegmentDesign> found;  ///< best first, feasible ones before others
  SearchStatistics statistics;
};

/// How much a search takes upon itself.
struct SegmentEffort {
  /// Refined, where the file says nothing: a third is drawn, the others are good designs disturbed;
  /// 0: none but known ones.
  int starts = 360;
  /// Of the best, beyond the designs wanted: how many are refined further, and to the last digit.
  std::size_t deepened = 7, finished = 1;
};

/// The solver of the last refinement: the file's, or Gauss-Newton for the least deviation and Ipopt
/// for the greatest length and the least size. All others are by Gauss-Newton.
synthesis::Solver last_solver(const StraightLineProblem& problem);

/// Optima of a problem in the search's unit (`in_unit`), equal for any number of threads. `known`:
/// further segments to begin with. Counts what was done in `work`.
SegmentSearchResult search_segments(const StraightLineProblem& problem,
                                    const std::vector<LinkageSegment>& known,
                                    const SegmentEffort& effort, const Run& run,
                                    const Deadline& deadline, Work& work);

/// Limits met to this count as met while searching.
inline constexpr double kSegmentFeasibility = 1e-8;

}  // namespace cognate::problems
