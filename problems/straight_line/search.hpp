/// @file The global search for straight lines: starts, their minimax refinement, the best of those.
#pragma once

#include <string>
#include <vector>

#include "problems/linkage/deadline.hpp"
#include "problems/linkage/result.hpp"
#include "problems/search/thoroughness.hpp"
#include "problems/straight_line/starts.hpp"
#include "problems/straight_line/stretch.hpp"

namespace cognate::problems {

/// A local optimum. `stretch` has its own best line: `fit_line`.
struct FoundStretch {
  LineStretch stretch;
  double objective = 0;  ///< δ/L, 1/L or size over length, less is better
  double violation = 0;  ///< of the limits, relative
  double promise = 0;    ///< of a refined start: an objective that refinement may reach
  std::string origin;    ///< the family of its start
};

struct StretchSearchResult {
  std::vector<FoundStretch> found;  ///< best first, feasible ones before others
  SearchThoroughness thoroughness;
};

/// How much a search takes upon itself.
struct StretchEffort {
  int starts = 120;  ///< refined, where the file says nothing; 0: none but known ones
  /// Of the best, beyond the designs wanted: how many are refined further, and to the last digit.
  std::size_t deepened = 7, finished = 1;
};

/// Optima of a problem in the search's unit (`in_unit`), equal for any number of threads. `known`:
/// stretches to begin with besides. Counts what was done in `work`.
StretchSearchResult search_stretches(const StraightLineProblem& problem,
                                     const std::vector<LineStretch>& known,
                                     const StretchEffort& effort, const Run& run,
                                     const Deadline& deadline, Work& work);

/// Limits met to this count as met while searching.
inline constexpr double kStretchFeasibility = 1e-8;

/// Whether two stretches are of one linkage, or of its mirror image in the frame, to `tolerance` in
/// lengths over the longest and in angles.
bool same_stretch(const LineStretch& a, const LineStretch& b, double tolerance);

}  // namespace cognate::problems
