#include "problems/search/pareto_front.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/numbers/constants.hpp"
#include "problems/linkage/verify.hpp"

namespace cognate::problems {
namespace {

/// How many local minima of a point are starts of others.
constexpr std::size_t kStarts = 6;
/// Gaps of levels narrower than this share of the front are not looked into.
constexpr double kNarrow = 1e-3;
/// A front counts as evenly filled when no gap is wider than this many times the mean.
constexpr double kEven = 1.2;
/// Relative differences of errors up to this are what refinements leave open.
constexpr double kSameError = 1e-9;
/// A level counts as kept by what checks allow.
constexpr double kSameLevel = 2 * kCheckTolerance;
/// What is this share of the least value counts as nothing, where a measure vanishes.
constexpr double kNothing = 1e-3;

bool is_as_good(const FrontPoint& a, const FrontPoint& b) {
  return a.level >= b.level - kSameLevel && a.error <= b.error * (1 + kSameError);
}

void add_work(const Work& done, Work& work) {
  work.candidates += done.candidates;
  work.positions += done.positions;
  work.velocities += done.velocities;
  work.accelerations += done.accelerations;
  work.gradients += done.gradients;
  work.solver_iterations += done.solver_iterations;
}

}  // namespace

void add_minima(const FrontPoint& point, std::vector<Design>& designs) {
  const std::size_t count = std::min(point.minima.size(), kStarts);
  designs.insert(designs.end(), point.minima.begin(),
                 point.minima.begin() + static_cast<std::ptrdiff_t>(count));
}

/// Between neighbours; `after` counts from 0.
struct FrontSearch::Gap {
  std::size_t after = 0;
  double width = 0;
};

FrontSearch::FrontSearch(const FrontProblem& problem, const Run& run, const Deadline& deadline,
                         Work& work)
    : problem_(problem), run_(run), deadline_(deadline), work_(work) {}

void FrontSearch::report() {
  share_ += 0.04 * (1 - share_);
  if (run_.progress) run_.progress(share_, kInfinity);
}

double FrontSearch::level_of(const Design& design) {
  const double value = problem_.rule.value(design);
  if (problem_.rule.greatest_is_best) return problem_.rule.level(value);
  if (value > 0) {
    least_ = std::min(least_, value);
  } else if (nothing_ == 0 && std::isfinite(least_)) {
    nothing_ = kNothing * least_;
  }
  return problem_.rule.level(std::max(value, nothing_));
}

Result FrontSearch::begin() {
  Result first = problem_.solve(problem_.limits, {}, run_.seed);
  ++searches_;
  add_work(first.work, work_);
  report();
  if (!first.designs.empty() && all_satisfied(first.designs.front().constraints)) {
    const Design& best = first.designs.front();
    const double error = problem_.error(best);
    const double level = level_of(best);
    insert({-kInfinity, level, error <= problem_.met ? 0 : error, first.designs});
  }
  return first;
}

/// The best design whose level is at least `bound`; none where none is found, or in time.
std::optional<FrontPoint> FrontSearch::solved(double bound, const std::vector<Design>& known,
                                              bool afresh) {
  if (deadline_.reached()) return std::nullopt;
  DesignLimits limits = problem_.limits;
  if (nothing_ > 0 && bound > top_level()) return std::nullopt;
  const bool bounded = std::isfinite(bound);
  if (bounded && !problem_.rule.limit(limits, problem_.rule.value_at(bound))) return std::nullopt;
  // Each search has draws of its own: what one misses the next may find.
  const auto seed =
      afresh ? std::optional(run_.seed + static_cast<std::uint64_t>(searches_)) : std::nullopt;
  Result found = problem_.solve(limits, known, seed);
  ++searches_;
  add_work(found.work, work_);
  if (afresh) report();
  if (deadline_.reached() || found.status != Status::solved) return std::nullopt;
  const Design& best = found.designs.front();
  const double error = problem_.error(best);
  const double level = level_of(best);
  return FrontPoint{bound, level, error <= problem_.met ? 0 : error, std::move(found.designs)};
}

/// The minima of the points next to a level on either side, and of one that stands there.
std::vector<Design> FrontSearch::beside(double level) const {
  std::vector<Design> designs;
  auto at = std::ranges::lower_bound(points_, level - kSameLevel, {}, &FrontPoint::level);
  if (at != points_.begin()) --at;
  for (int i = 0; i < 3 && at != points_.end(); ++i, ++at) add_minima(*at, designs);
  return designs;
}

/// Keeps the points in order and none that another is as good as. One that stays is the best of
/// every bound that the other was found under.
void FrontSearch::insert(FrontPoint point) {
  for (FrontPoint& known : points_) {
    if (!is_as_good(known, point)) continue;
    known.bound = std::min(known.bound, point.bound);
    return;
  }
  std::erase_if(points_, [&](const FrontPoint& known) { return is_as_good(point, known); });
  const auto at = std::ranges::lower_bound(points_, point.level, {}, &FrontPoint::level);
  points_.insert(at, std::move(point));
}

/// Relative to the whole front in both directions.
double FrontSearch::distance(const FrontPoint& a, const FrontPoint& b) const {
  const FrontPoint &first = points_.front(), &last = points_.back();
  const auto share = [](double part, double whole) { return whole > 0 ? part / whole : 0; };
  return std::hypot(share(b.level - a.level, last.level - first.level),
                    share(b.error - a.error, last.error - first.error));
}

/// Of those that are open: a point is the best of all bounds from that asked for to its level.
std::optional<FrontSearch::Gap> FrontSearch::widest_gap() const {
  std::optional<Gap> widest;
  const double whole = points_.back().level - points_.front().level;
  for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
    if (points_[i + 1].bound - points_[i].level <= kNarrow * whole) continue;
    const double width = distance(points_[i], points_[i + 1]);
    if (!widest || width > widest->width) widest = Gap{i, width};
  }
  return widest;
}

/// Where nothing better is found, the point after the gap is the best of all its bounds.
void FrontSearch::split(const Gap& gap) {
  const FrontPoint &before = points_[gap.after], &after = points_[gap.after + 1];
  const double bound = 0.5 * (before.level + after.bound);
  FrontPoint fallback = after;
  fallback.bound = bound;
  std::vector<Design> known;
  add_minima(before, known);
  add_minima(after, known);
  auto point = solved(bound, known, true);
  const bool better = point && !is_as_good(fallback, *point);
  insert(better ? *std::move(point) : std::move(fallback));
}

/// Solves each again from the points beside it, until that gains nothing.
void FrontSearch::settle() {
  constexpr int kRounds = 3;
  for (int round = 0; round < kRounds; ++round) {
    std::vector<double> bounds;
    for (const FrontPoint& point : points_) bounds.push_back(point.bound);
    double gain = 0;
    for (const double bound : bounds) {
      if (deadline_.reached()) return;
      const auto known = std::ranges::find(points_, bound, &FrontPoint::bound);
      if (known == points_.end()) continue;
      auto point = solved(bound, beside(known->level), false);
      if (!point || !(point->error < known->error * (1 - kSameError))) continue;
      gain = std::max(gain, 1 - point->error / known->error);
      if (point->level >= known->level - kSameLevel) {
        points_.erase(known);
      } else {
        known->bound = known->level;  // the best of the levels between is the new one
      }
      insert(*std::move(point));
    }
    if (gain < 1e-7) return;
  }
}

/// Leaves out the point whose neighbours are nearest to each other, again and again.
void FrontSearch::thin(std::size_t count) {
  while (points_.size() > count) {
    std::size_t least = 1;
    for (std::size_t i = 2; i + 1 < points_.size(); ++i) {
      const double apart = distance(points_[i - 1], points_[i + 1]);
      if (apart < distance(points_[least - 1], points_[least + 1])) least = i;
    }
    points_.erase(points_.begin() + static_cast<std::ptrdiff_t>(least));
  }
}

/// Where a point of some bound was better than the best without any, what is best without is looked
/// for again from there.
void FrontSearch::look_before_first() {
  const double none = -kInfinity;
  if (points_.front().bound == none || deadline_.reached()) return;
  auto point = solved(none, points_.front().minima, true);
  points_.front().bound = none;
  if (point && !is_as_good(points_.front(), *point)) insert(*std::move(point));
}

void FrontSearch::fill(int count) {
  for (int i = 0; i < 2 * count && !deadline_.reached(); ++i) {
    look_before_first();
    const auto gap = widest_gap();
    if (!gap) break;
    double whole = 0;
    for (std::size_t k = 0; k + 1 < points_.size(); ++k) {
      whole += distance(points_[k], points_[k + 1]);
    }
    const bool even = gap->width <= kEven * whole / (count - 1);
    if (even && points_.size() >= static_cast<std::size_t>(count)) break;
    split(*gap);
  }
  settle();
  thin(static_cast<std::size_t>(count));
}

}  // namespace cognate::problems
