#include "synthesis/search/pareto_front.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "analysis/numbers/constants.hpp"

namespace cognate::synthesis {
namespace {

/// How many local minima of a point are starts of others.
constexpr std::size_t kStarts = 6;
/// Gaps of levels narrower than this share of the front are not looked into.
constexpr double kNarrow = 1e-3;
/// A front counts as evenly filled when no gap is wider than this many times the mean.
constexpr double kEven = 1.2;
/// Relative differences of errors up to this are what refinements leave open.
constexpr double kSameError = 1e-9;
/// A level counts as kept by what checks of limits allow.
constexpr double kSameLevel = 2e-9;
/// What is this share of the least value counts as nothing, where a measure vanishes.
constexpr double kNothing = 1e-3;

bool is_as_good(const FrontPoint& a, const FrontPoint& b) {
  return a.level >= b.level - kSameLevel && a.error <= b.error * (1 + kSameError);
}

}  // namespace

FrontMeasure measure_of_values(bool greatest_is_best, double best) {
  if (greatest_is_best) return {true, best, std::identity{}, std::identity{}};
  return {false, best, [](double value) { return -std::log(value); },
          [](double level) { return std::exp(-level); }};
}

void FrontPoint::add_minima(std::vector<std::size_t>& known) const {
  for (std::size_t i = 0; i < std::min(minima.size(), kStarts); ++i) {
    known.push_back(minima[i].number);
  }
}

/// Between neighbours; `after` counts from 0.
struct FrontSearch::Gap {
  std::size_t after = 0;
  double width = 0;
};

FrontSearch::FrontSearch(const FrontProblem& problem, const FrontRun& run)
    : problem_(problem), run_(run) {}

void FrontSearch::report() {
  share_ += 0.04 * (1 - share_);
  if (run_.progress) run_.progress(share_, kInfinity);
}

double FrontSearch::level_of(double value) {
  const FrontMeasure& measure = problem_.measure;
  if (measure.greatest_is_best) return measure.level(value);
  if (value > 0) {
    least_ = std::min(least_, value);
  } else if (nothing_ == 0 && std::isfinite(least_)) {
    nothing_ = kNothing * least_;
  }
  return measure.level(std::max(value, nothing_));
}

FrontPoint FrontSearch::point_of(double bound, std::vector<FrontDesign> designs) {
  const FrontDesign& best = designs.front();
  const double level = level_of(best.value);
  return {bound, level, best.error <= problem_.met ? 0 : best.error, std::move(designs)};
}

void FrontSearch::begin() {
  auto found = problem_.solve(std::nullopt, {}, run_.seed);
  ++searches_;
  report();
  if (found && !found->empty()) insert(point_of(-kInfinity, std::move(*found)));
}

/// The best design whose level is at least `bound`; none where none is found, or in time.
std::optional<FrontPoint> FrontSearch::solved(double bound, const Known& known, bool afresh) {
  if (run_.deadline.reached()) return std::nullopt;
  if (nothing_ > 0 && bound > top_level()) return std::nullopt;
  std::optional<double> limit;
  if (std::isfinite(bound)) limit = problem_.measure.value_at(bound);
  // Each search has draws of its own: what one misses the next may find.
  const auto seed =
      afresh ? std::optional(run_.seed + static_cast<std::uint64_t>(searches_)) : std::nullopt;
  auto found = problem_.solve(limit, known, seed);
  if (!found) return std::nullopt;
  ++searches_;
  if (afresh) report();
  if (run_.deadline.reached() || found->empty()) return std::nullopt;
  return point_of(bound, std::move(*found));
}

/// The minima of the points next to a level on either side, and of one that stands there.
FrontSearch::Known FrontSearch::beside(double level) const {
  Known designs;
  auto at = std::ranges::lower_bound(points_, level - kSameLevel, {}, &FrontPoint::level);
  if (at != points_.begin()) --at;
  for (int i = 0; i < 3 && at != points_.end(); ++i, ++at) at->add_minima(designs);
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

/// Of those that are open: a point is the best of all bounds from that requested to its level.
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
  Known known;
  before.add_minima(known);
  after.add_minima(known);
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
      if (run_.deadline.reached()) return;
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
  if (points_.front().bound == none || run_.deadline.reached()) return;
  Known known;
  points_.front().add_minima(known);
  auto point = solved(none, known, true);
  points_.front().bound = none;
  if (point && !is_as_good(points_.front(), *point)) insert(*std::move(point));
}

void FrontSearch::step(double first, double step, int count, double most) {
  for (int i = 0; i < count; ++i) {
    const double level = first + i * step;
    const bool afresh = i % 2 == 0;
    auto point = solved(level, beside(level), afresh);
    if (!point && !afresh) point = solved(level, beside(level), true);
    if (!point || point->error > most) break;
    insert(*std::move(point));
  }
  settle();
}

void FrontSearch::fill(int count) {
  for (int i = 0; i < 2 * count && !run_.deadline.reached(); ++i) {
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

std::vector<FrontMinimum> pareto_front(const ModelWithin& model, const FrontMeasure& measure,
                                       const std::function<double(const Minimum&)>& value,
                                       int count, double met, const SearchOptions& options) {
  const Deadline deadline(options.time_limit, options.cancelled);
  std::vector<FrontMinimum> all;
  const auto solve =
      [&](std::optional<double> bound, const std::vector<std::size_t>& known,
          std::optional<std::uint64_t> seed) -> std::optional<std::vector<FrontDesign>> {
    const auto bounded = model(bound);
    if (!bounded) return std::nullopt;
    SearchOptions own = options;
    own.progress = nullptr;
    own.time_limit = deadline.remaining();
    own.seed = seed.value_or(options.seed);
    if (!seed) own.rule.starts = 0;
    for (const std::size_t one : known) own.known.push_back({all[one].minimum.solution.x});
    std::vector<FrontDesign> designs;
    for (Minimum& minimum : search(*bounded, own).minima) {
      if (minimum.solution.violation > options.feasibility) break;
      const double reached = value(minimum);
      designs.push_back({all.size(), reached, minimum.solution.objective});
      all.push_back({std::move(minimum), reached});
    }
    return designs;
  };
  const FrontProblem problem{measure, met, solve};
  FrontSearch search(problem, {options.seed, deadline, options.progress});
  search.begin();
  if (search.points().empty()) return {};
  if (search.points().front().error == 0) search.go_to(0, LastPoint::before_an_upright_end);
  search.go_to(kInfinity, LastPoint::before_an_upright_end);
  search.fill(count);
  std::vector<FrontMinimum> front;
  for (const FrontPoint& point : search.points()) front.push_back(all[point.design().number]);
  return front;
}

}  // namespace cognate::synthesis
