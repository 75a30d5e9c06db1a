/// The ends of a front: the greatest level within a bound on the error, or that there is at all.
#include <algorithm>
#include <cmath>
#include <utility>

#include "synthesis/search/pareto_front.hpp"

namespace cognate::synthesis {
namespace {

/// Fresh searches that halve the levels before the root is closed in on, and how often some look
/// beyond the root, by which shares of the levels.
constexpr int kCoarse = 5, kLooks = 5;
constexpr double kBeyond[] = {1e-3, 1e-5};
/// And by which shares of the levels that no search has decided.
constexpr double kBetween[] = {0.5, 0.25, 0.12, 0.06, 0.03};
/// The root is known to this share of the levels.
constexpr double kRoot = 1e-8;
/// How far before the end of a front points are looked at, the last being the end itself.
constexpr double kBack[] = {1e-2, 1e-3, 1e-4, 1e-5, 1e-6};
/// Where no best value of a measure is known, levels up to this much better are looked at, for
/// lengths and ratios a factor of a thousand; and as much beyond those if there is something, so
/// many times.
constexpr double kReach = 6.9;
constexpr int kReaches = 6;

}  // namespace

/// The level that no design passes; infinite where none is known.
double FrontSearch::top_level() const {
  return problem_.measure.level(std::max(problem_.measure.best, nothing_));
}

bool FrontSearch::has_top() const {
  return std::isfinite(top_level());
}

/// That level, or one that is looked at first.
double FrontSearch::top(double from) const {
  return has_top() ? top_level() : from + kReach;
}

/// The greatest level at which the error is at most so much, closed in on.
class FrontSearch::Root {
 public:
  Root(FrontSearch& front, double most)
      : front_(front), most_(most), best_(front.last_within(most)), low_(best_.level) {
    high_ = front.top(low_);
    way_ = high_ - low_;
    failed_ = {high_};
  }

  void find() {
    if (!std::isfinite(low_)) return;  // nothing is better than a measure of 0
    if (!front_.has_top()) reach_out();
    for (int i = 0; i < kCoarse && is_open(); ++i) probe(0.5 * (low_ + high_), true);
    for (int look = 0; look < kLooks; ++look) {
      while (is_open()) probe(0.5 * (low_ + high_), false);
      if (!goes_on()) break;
      high_ = std::max(failed_.back(), low_);
    }
  }

  const FrontPoint& best() const { return best_; }
  double way() const { return way_; }
  /// Whether something was found beyond, of too great an error.
  bool is_crossed() const { return beyond_.has_value(); }

 private:
  bool is_open() const { return high_ - low_ > kRoot * way_ && !front_.run_.deadline.reached(); }

  /// As far as fresh searches find anything.
  void reach_out() {
    const double begin = low_;
    for (int reach = 0; reach < kReaches && probe(high_, true); ++reach) high_ = low_ + kReach;
    way_ = high_ - begin;
    failed_ = {high_};
  }

  bool probe(double level, bool afresh) {
    Known known;
    best_.add_minima(known);
    if (beyond_) beyond_->add_minima(known);
    auto point = front_.solved(level, known, afresh);
    if (point && point->error <= most_) {
      low_ = std::max(level, point->level);
      best_ = *std::move(point);
      if (afresh) front_.insert(best_);
      return true;
    }
    if (point) beyond_ = *std::move(point);
    high_ = level;
    if (afresh) failed_.push_back(level);
    return false;
  }

  /// Refinement from neighbours may stick where a fresh search, further on or nearer, does not, and
  /// may pass where one failed.
  bool goes_on() {
    const auto looks = [&](double level) {
      return level < failed_.back() && !front_.run_.deadline.reached() && probe(level, true);
    };
    if (failed_.size() > 1 && probe_failed()) return true;
    const double open = failed_.back() - low_;
    return std::ranges::any_of(kBetween,
                               [&](double share) { return looks(low_ + share * open); }) ||
           std::ranges::any_of(kBeyond, [&](double share) { return looks(low_ + share * way_); });
  }

  /// Goes from the best to where a fresh search failed last; what is passed is forgotten.
  bool probe_failed() {
    if (front_.run_.deadline.reached() || !probe(failed_.back(), false)) return false;
    while (failed_.size() > 1 && failed_.back() <= low_) failed_.pop_back();
    return true;
  }

  FrontSearch& front_;
  double most_;
  FrontPoint best_;
  std::optional<FrontPoint> beyond_;
  double low_, high_ = 0, way_ = 0;
  /// Levels at which fresh searches have failed, below the top, each less than the one before.
  std::vector<double> failed_;
};

/// Errors grow from point to point.
const FrontPoint& FrontSearch::last_within(double most) const {
  return *std::prev(std::ranges::partition_point(
      points_, [&](const FrontPoint& point) { return point.error <= most; }));
}

/// Points of levels ever less before that of `last`, each from the one before; the last of them.
FrontPoint FrontSearch::stepped_back(const FrontPoint& last, double way) {
  FrontPoint end = last;
  Known known = beside(last.level);
  last.add_minima(known);
  for (const double share : kBack) {
    auto point = solved(last.level - share * way, known, false);
    if (!point) continue;
    end = *std::move(point);
    insert(end);
    known.clear();
    last.add_minima(known);
    end.add_minima(known);
  }
  std::erase_if(points_, [&](const FrontPoint& point) {
    return point.level > end.level && point.error >= end.error;
  });
  insert(end);
  return points_.back();
}

FrontPoint FrontSearch::go_to(double most, LastPoint last) {
  Root root(*this, most);
  root.find();
  ended_by_error_ = root.is_crossed();
  const bool ends = !ended_by_error_ && root.best().level > points_.front().level;
  const bool before = ends && last == LastPoint::before_an_upright_end;
  const FrontPoint best = before ? stepped_back(root.best(), root.way()) : root.best();
  insert(best);
  return best;
}

}  // namespace cognate::synthesis
