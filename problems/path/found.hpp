/// @file Minima of a path search on their way: their order, their merging and the work they took.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "problems/path/search.hpp"

namespace cognate::problems {

/// Violations up to this count as none.
inline constexpr double kPathFeasibility = 1e-9;

/// A start, or what has been made of it.
struct PathFound {
  PathMinimum minimum;
  bool valid = false;
  bool fitted = false;    ///< not as it was drawn
  bool deepened = false;  ///< fitted to its end
  bool binds = false;     ///< order holds points: a fit that knows none leads away
  bool strays = false;    ///< from order, or a closed curve: no use, however low the cost
  double cost = 0;        ///< of a fit in lanes: objective and penalties
  int hits = 1;           ///< how many starts have come here
  /// Work not yet counted, that of refinements which were no better among it.
  std::uint64_t evaluations = 0, gradients = 0, iterations = 0;
};

/// Those that stray last, feasible ones first, then by objective or violation.
bool is_better(const PathFound& a, const PathFound& b);

/// Those that stray last, then by the cost of a fit in lanes.
bool costs_less(const PathFound& a, const PathFound& b);

/// Sorts by `before`, drops those without a value and counts those that are the same point as an
/// earlier one, up to `tolerance` relative to 1 + |x|, among its hits.
void sort_and_merge(std::vector<PathFound>& all,
                    const std::function<bool(const PathFound&, const PathFound&)>& before,
                    double tolerance);

/// Goes on from the point of `found`, by the loss that the problem asks for (a point's two
/// residuals being one error), and counts the work.
synthesis::Solution minimise(const PathProblem& problem, PathFound& found,
                             synthesis::Backend backend, const synthesis::Options& options);

/// Brings a minimum that meets its points nearly to rounding, as far as its condition permits.
void polish(const PathProblem& problem, PathFound& found, const synthesis::Options& options);

/// Moves the points that are not timed to the places of the curve where they are nearest to it in
/// order, in the sense of the crank that suits them best if it is open; no loss counts here. What
/// cannot pass them in order strays.
void place_in_order(const PathProblem& problem, PathFound& found);

/// Moves the work of all into `work`.
void count_work(std::span<PathFound> all, std::size_t points, Work& work);

}  // namespace cognate::problems
