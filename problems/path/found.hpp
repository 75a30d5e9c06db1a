/// @file Minima of a path search on their way: their order, their merging and the work they took.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "problems/linkage/verify.hpp"
#include "problems/path/search.hpp"
#include "synthesis/search/multi_start.hpp"

namespace cognate::problems {

/// Violations of a model's constraints up to this count as none: less than the checks of a design
/// allow, which are relative to its own links. Refinements go to a tenth.
inline constexpr double kPathFeasibility = 1e-10;

/// Of several designs whose costs differ by less, relative, most lie in one valley.
inline constexpr double kOneValley = 0.01;

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

/// How minima are ranked, while starts are explored by cost, and distinguished.
struct PathRules {
  using Candidate = PathFound;
  bool by_cost = false;

  static bool has_value(const PathFound& found) { return found.valid; }
  bool precedes(const PathFound& a, const PathFound& b) const {
    return by_cost ? costs_less(a, b) : is_better(a, b);
  }
  /// Whether they are the same point up to `tolerance` relative to 1 + |x|, or lie in one valley.
  static bool is_same(const PathFound& known, const PathFound& other, double tolerance);
  static void absorb(PathFound& known, const PathFound& same) {
    known.minimum.from_exact = known.minimum.from_exact || same.minimum.from_exact;
  }
  static double value(const PathFound& found);
  /// The best, of many in one valley a few unless there are no others.
  void keep(std::vector<PathFound>& sorted, std::size_t most) const;
  /// Whether their merits agree to a hundredth, or both meet their points to rounding, which none
  /// does better. Fits end at places of their own in one long valley.
  bool is_near(const PathFound& best, const PathFound& other) const {
    return merit(other) <= std::max(kMetExactly, (1 + kOneValley) * merit(best));
  }
  /// The same, but designs that meet their points to rounding are each one of its own.
  bool lie_in_one_valley(const PathFound& best, const PathFound& other) const {
    return merit(best) > kMetExactly && is_near(best, other);
  }
  double merit(const PathFound& found) const { return by_cost ? found.cost : value(found); }
};

/// Goes on from the point of `found`, by the loss of the problem (a point's two
/// residuals being one error), and counts the work.
synthesis::Solution minimise(const PathProblem& problem, PathFound& found, synthesis::Solver solver,
                             const synthesis::Options& options);

/// Brings a minimum that meets its points nearly to rounding, as far as its condition permits.
void polish(const PathProblem& problem, PathFound& found, const synthesis::Options& options);

/// Moves the points that are not timed to the places of the curve where they are nearest to it in
/// order, in the sense of the crank that suits them best if it is open; no loss counts here. What
/// cannot pass them in order strays.
void place_in_order(const PathProblem& problem, PathFound& found);

/// Moves the work of all into `work`.
void count_work(std::span<PathFound> all, std::size_t points, Work& work);

}  // namespace cognate::problems
