/// @file The Pareto front of the error and another measure, by the method of the ε-constraint
/// (Haimes, Lasdon & Wismer 1971): the measure is bounded and the error minimised, for bound after
/// bound. A front is thus a row of ordinary problems, each begun from the designs beside it too.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "synthesis/search/deadline.hpp"
#include "synthesis/search/search.hpp"

namespace cognate::synthesis {

/// A design of a front, which the caller knows by its number.
struct FrontDesign {
  std::size_t number = 0;
  double value = 0;  ///< of the measure
  double error = 0;
};

/// How values of the measure are levels: numbers that grow as designs get better, so that equal
/// steps of them are equal gains.
struct FrontMeasure {
  bool greatest_is_best = false;
  double best = 0;  ///< value that no design passes
  std::function<double(double value)> level;
  std::function<double(double level)> value_at;
};

/// Levels of angles, of which the greatest is best: the values themselves; or of lengths and
/// ratios, of which the least is: their negative logarithms. `best`: as in FrontMeasure.
FrontMeasure measure_of_values(bool greatest_is_best, double best);

/// A problem with a second measure, as the search along its front sees it.
struct FrontProblem {
  FrontMeasure measure;
  double met = 0;  ///< errors up to this are rounding
  /// Designs of least error, best first, of a value no worse than `bound`, if there is one, from
  /// designs of those numbers and, unless `seed` is empty, from starts of its own. No design where
  /// none is feasible; nothing where the bound allows none at all and nothing was tried. The same
  /// for the same arguments.
  std::function<std::optional<std::vector<FrontDesign>>(std::optional<double> bound,
                                                        const std::vector<std::size_t>& known,
                                                        std::optional<std::uint64_t> seed)>
      solve;
};

/// A point of the front, and what it was found under.
struct FrontPoint {
  double bound = 0;  ///< the level that was requested, −∞ for none; see FrontMeasure::level
  double level = 0;  ///< the level that it has
  double error = 0;  ///< 0 where the target is met
  std::vector<FrontDesign> minima;  ///< the best found and a few other local minima

  /// The best found.
  const FrontDesign& design() const { return minima.front(); }

  /// Adds the numbers of the best and some other minima to `known`.
  void add_minima(std::vector<std::size_t>& known) const;
};

/// How a search along a front is run.
struct FrontRun {
  std::uint64_t seed = 1;
  const Deadline& deadline;
  std::function<void(double share, double best)> progress{};
};

/// Where a search for the end of a front goes; see `FrontSearch::go_to`.
enum class LastPoint { before_an_upright_end, greatest_level };

/// Points of the front that are known, best error first: none is as good as another in both.
///
/// The front falls or rises monotonically, since what meets a bound meets every looser one:
/// a point that is found better than one of a looser bound takes its place, and each point is a
/// start for those beside it.
class FrontSearch {
 public:
  /// `problem` must outlive the search.
  FrontSearch(const FrontProblem& problem, const FrontRun& run);

  /// Adds the design of least error of any level; there is no point if there is none.
  void begin();

  /// Adds the point of the greatest level whose error is at most `most`, and returns it: a search
  /// for the root of the error, which grows with the level, to 1e-8 of the levels looked at. Fresh
  /// searches narrow it down, and look beyond it in the end. Where nothing is found beyond at all,
  /// the front may end upright: the point before that is of a level less by 1e-6 of those looked
  /// at. At least one point is known whose error is no greater.
  FrontPoint go_to(double most, LastPoint last);

  /// Whether beyond the point last gone to something was found, of too great an error.
  bool ended_by_error() const { return ended_by_error_; }

  /// Adds points whose levels lie in equal steps from `first` on, at most `count`, every second one
  /// and those that no design beside them leads to searched afresh, until nothing is found or the
  /// error exceeds `most`; then each is found again
  /// from those beside it. Where errors fall by powers of ten an even row of levels shows more of a
  /// front than `fill` does.
  void step(double first, double step, int count, double most);

  /// Adds points between those that are known, in the widest gaps first, until `count` of them
  /// can lie evenly along the front; then leaves so many.
  void fill(int count);

  /// In their order along the front.
  const std::vector<FrontPoint>& points() const { return points_; }
  /// How many problems were solved.
  int searches() const { return searches_; }

 private:
  struct Gap;

  class Root;

  using Known = std::vector<std::size_t>;  ///< numbers of designs

  FrontPoint point_of(double bound, std::vector<FrontDesign> designs);
  std::optional<FrontPoint> solved(double bound, const Known& known, bool afresh);
  FrontPoint stepped_back(const FrontPoint& last, double way);
  Known beside(double level) const;
  void insert(FrontPoint point);
  double level_of(double value);
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
  FrontRun run_;
  bool ended_by_error_ = false;
  int searches_ = 0;  ///< problems solved
  double share_ = 0;  ///< done, for progress
  /// Where least is best, the least value above 0 until one of 0 is found; then a thousandth of it,
  /// which what is less counts as, so that levels have an end.
  double least_ = std::numeric_limits<double>::infinity(), nothing_ = 0;
  std::vector<FrontPoint> points_;
};

/// A model within a bound on the measure, empty for none; null where the bound allows no design.
using ModelWithin = std::function<std::shared_ptr<const Model>(std::optional<double> bound)>;

/// A point of the front of a model.
struct FrontMinimum {
  Minimum minimum;
  double value = 0;  ///< of the measure
};

/// The front of a model's objective and a measure `value` of its minima, `count` points, best
/// objective first. `model` adds the bound to the constraints; `met` is the objective that counts
/// as 0. Without a minimum within limits the front is empty.
std::vector<FrontMinimum> pareto_front(const ModelWithin& model, const FrontMeasure& measure,
                                       const std::function<double(const Minimum&)>& value,
                                       int count, double met, const SearchOptions& options = {});

}  // namespace cognate::synthesis
