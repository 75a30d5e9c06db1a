/// @file The Pareto front of the error and another measure, by the method of the ε-constraint
/// (Haimes, Lasdon & Wismer 1971): the measure is bounded and the error minimised, for bound after
/// bound. A front is thus a row of ordinary problems, each begun from the designs beside it too.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "problems/linkage/deadline.hpp"
#include "problems/linkage/result.hpp"
#include "problems/search/measures.hpp"

namespace cognate::problems {

/// A problem with a second measure, as the search along its front sees it.
struct FrontProblem {
  DesignLimits limits;  ///< those of the file
  const MeasureRule& rule;
  double met = 0;  ///< errors up to this are rounding
  std::function<double(const Design&)> error;
  /// Designs of least error within limits, from designs that are known and, unless `seed` is empty,
  /// from starts of its own. The same for the same arguments.
  std::function<Result(const DesignLimits& limits, const std::vector<Design>& known,
                       std::optional<std::uint64_t> seed)>
      solve;
};

struct FrontPoint {
  double bound = 0;  ///< the level that was asked for, −∞ for none; see MeasureRule::level
  double level = 0;  ///< the level that it has
  double error = 0;  ///< 0 where the target is met
  std::vector<Design> minima;  ///< the best found and a few other local minima

  const Design& design() const { return minima.front(); }
};

/// Adds the best and some other minima of a point to `designs`.
void add_minima(const FrontPoint& point, std::vector<Design>& designs);

enum class LastPoint { before_an_upright_end, greatest_level };

/// Points of the front that are known, best error first: none is as good as another in both.
///
/// The front falls or rises monotonically, since what keeps to a bound keeps to every looser one:
/// a point that is found better than one of a looser bound takes its place, and each point is a
/// start for those beside it.
class FrontSearch {
 public:
  FrontSearch(const FrontProblem& problem, const Run& run, const Deadline& deadline, Work& work);

  /// Adds the design of least error whatever its level. What the search gave is returned; only if
  /// its status is `solved`, or a feasible design is known as the time ends, is there a point.
  Result begin();

  /// Adds the point of the greatest level whose error is at most `most`, and returns it: a search
  /// for the root of the error, which grows with the level, to 1e-8 of the levels looked at. Fresh
  /// searches narrow it down, and look beyond it in the end. Where nothing is found beyond at all,
  /// the front may end upright: the point before that is of a level less by 1e-6 of those looked
  /// at. At least one point is known whose error is no greater.
  FrontPoint go_to(double most, LastPoint last);

  /// Whether beyond the point last gone to something was found, of too great an error.
  bool ended_by_error() const { return ended_by_error_; }

  /// Adds points between those that are known, in the widest gaps first, until `count` of them
  /// can lie evenly along the front; then leaves so many.
  void fill(int count);

  const std::vector<FrontPoint>& points() const { return points_; }
  int searches() const { return searches_; }

 private:
  struct Gap;

  class Root;

  std::optional<FrontPoint> solved(double bound, const std::vector<Design>& known, bool afresh);
  FrontPoint stepped_back(const FrontPoint& last, double way);
  std::vector<Design> beside(double level) const;
  void insert(FrontPoint point);
  double level_of(const Design& design);
  double top_level() const;
  bool has_top() const;
  double top(double from) const;
  const FrontPoint& last_within(double most) const;
  double distance(const FrontPoint& a, const FrontPoint& b) const;
  std::optional<Gap> widest_gap() const;
  void split(const Gap& gap);
  void settle();
  void look_before_first();
  void thin(std::size_t count);
  void report();

  const FrontProblem& problem_;
  const Run& run_;
  const Deadline& deadline_;
  Work& work_;
  bool ended_by_error_ = false;
  int searches_ = 0;  ///< problems solved
  double share_ = 0;  ///< done, for progress
  /// Where least is best, the least value above 0 until one of 0 is found; then a thousandth of it,
  /// which what is less counts as, so that levels have an end.
  double least_ = std::numeric_limits<double>::infinity(), nothing_ = 0;
  std::vector<FrontPoint> points_;
};

}  // namespace cognate::problems
