#include "problems/path/search.hpp"

#include <algorithm>
#include <atomic>
#include <iterator>
#include <limits>
#include <utility>

#include "analysis/numbers/parallel.hpp"
#include "problems/path/explorer.hpp"
#include "problems/path/found.hpp"
#include "problems/path/thinning.hpp"

namespace cognate::problems {
namespace {

using synthesis::Solution;

constexpr int kDeepeningIterations = 2000;
constexpr int kFinishingIterations = 200, kPolishingIterations = 100;
/// How many explored starts are deepened, and how many of those are finished at all points of a
/// long list and by a back end of the user's choice, beyond twice the designs wanted.
constexpr std::size_t kDeepened = 64;
constexpr std::size_t kFinished = 2;
/// As `kDeepened` with limits over the turn, under which the explored starts have already come near
/// their minima.
constexpr std::size_t kLimitedDeepened = 24;
/// Minima are one up to what an unfinished refinement leaves open.
constexpr double kSameMinimum = 1e-6;
/// How many points a search looks at first, and next. What many points more say beyond these moves
/// a minimum by a few steps only.
constexpr std::size_t kFewPoints = 48, kManyPoints = 480;
constexpr int kFewestIterations = 12;

/// As many steps at `points` as the same time allows at `kManyPoints`.
int finishing_iterations(std::size_t points) {
  if (points <= kManyPoints) return kFinishingIterations;
  const std::size_t affordable = kFinishingIterations * kManyPoints / points;
  return std::max(kFewestIterations, static_cast<int>(affordable));
}

synthesis::Options options(const Deadline& deadline, int iterations, double tolerance,
                           std::uint64_t seed) {
  return {.tolerance = tolerance,
          .feasibility = kPathFeasibility,
          .max_iterations = iterations,
          .time_limit = deadline.remaining(),
          .interrupted = deadline.flag(),
          .seed = seed};
}

/// From some of the points to more: the same linkage, its crank angles interpolated, or those at
/// which it comes nearest to the points in order. Whatever refinement gives counts as better.
void carry_over(const PathThinning& some, const PathThinning& more, PathFound& found) {
  const PathModel coarse = model_of(some.coarse(), found.minimum);
  const PathModel fine = model_of(more.coarse(), found.minimum);
  Solution& solution = found.minimum.solution;
  const FourBar linkage = coarse.linkage(solution.x);
  const auto angles = some.interpolated(coarse.crank_angles(solution.x));
  solution.x = fine.variables_of(linkage, more.kept(angles));
  solution.objective = solution.violation = std::numeric_limits<double>::infinity();
  place_in_order(more.coarse(), found);
}

/// Goes on from `found` and keeps what is reached unless it is worse.
void refine(const PathProblem& problem, PathFound& found, synthesis::Backend backend,
            const synthesis::Options& options) {
  PathFound refined = found;
  refined.minimum.solution = minimise(problem, refined, backend, options);
  const bool lost = refined.minimum.solution.stop == synthesis::Stop::no_value;
  if (lost || is_better(found, refined)) refined.minimum = found.minimum;
  found = std::move(refined);
}

/// The stages of a search; each works on `all_` in place.
class PathSearch {
 public:
  PathSearch(const PathProblem& scaled, double tolerance, const Run& run, const Deadline& deadline,
             Work& work)
      : whole_(scaled),
        few_(scaled, kFewPoints),
        many_(scaled, kManyPoints),
        all_points_(scaled, scaled.points.size()),
        deepened_(limits_turn(scaled.constraints) ? kLimitedDeepened : kDeepened),
        tolerance_(tolerance),
        run_(run),
        deadline_(deadline),
        work_(work) {}

  void explore();
  void refine_best(const PathProblem& problem, std::size_t reserve, synthesis::Backend backend,
                   int iterations, const Range& shares);
  void finish(synthesis::Backend backend, const std::vector<PathMinimum>& in_order);
  void refine_at(const PathThinning& some, const PathThinning& more, const Range& shares);
  void add_in_order(const std::vector<PathMinimum>& minima);
  void polish_best();
  PathSearchResult take();

 private:
  void lower_best(const PathFound& found);
  std::size_t kept(std::size_t reserve) const {
    return reserve + 2 * static_cast<std::size_t>(whole_.solve.designs);
  }

  const PathProblem& whole_;
  PathThinning few_, many_, all_points_;
  std::size_t deepened_;
  double tolerance_;
  const Run& run_;
  const Deadline& deadline_;
  Work& work_;
  SearchThoroughness thoroughness_;
  int independent_ = 0;  ///< see `ExploredPaths`
  std::vector<PathFound> all_;
  std::atomic<double> best_{std::numeric_limits<double>::infinity()};  ///< for progress only
};

void PathSearch::lower_best(const PathFound& found) {
  if (!found.valid || found.minimum.solution.violation > kPathFeasibility) return;
  const double objective = found.minimum.solution.objective;
  double known = best_;
  while (objective < known && !best_.compare_exchange_weak(known, objective)) {
  }
}

void PathSearch::explore() {
  Run run = run_;
  for (Design& design : run.known) design.crank_angles = few_.kept(design.crank_angles);
  ExploredPaths explored =
      explore_paths(few_.coarse(), {whole_.solve.starts, kept(deepened_), run}, deadline_, work_);
  thoroughness_.starts = explored.starts;
  independent_ = explored.independent;
  all_ = std::move(explored.minima);
  for (const PathFound& found : all_) lower_best(found);
}

/// Goes on with `reserve` and twice the designs wanted.
void PathSearch::refine_best(const PathProblem& problem, std::size_t reserve,
                             synthesis::Backend backend, int iterations, const Range& shares) {
  if (all_.size() > kept(reserve)) all_.resize(kept(reserve));
  const double step = (shares.max - shares.min) / std::max<double>(1, double(all_.size()));
  parallel_for(static_cast<int>(all_.size()), run_.threads, [&](int index, int thread) {
    if (deadline_.reached()) return;
    refine(problem, all_[index], backend, options(deadline_, iterations, tolerance_, run_.seed));
    if (thread == 0 && run_.progress) run_.progress(shares.min + step * index, best_);
  });
  count_work(all_, problem.points.size(), work_);
  for (const PathFound& found : all_) lower_best(found);
  sort_and_merge(all_, is_better, kSameMinimum);
}

/// Goes on with the best at more points.
void PathSearch::refine_at(const PathThinning& some, const PathThinning& more,
                           const Range& shares) {
  if (all_.size() > kept(kFinished)) all_.resize(kept(kFinished));
  for (PathFound& found : all_) carry_over(some, more, found);
  const PathProblem& problem = more.coarse();
  refine_best(problem, kFinished, synthesis::Backend::gauss_newton,
              finishing_iterations(problem.points.size()), shares);
}

/// Brings the best to convergence at all points, and those `in_order` with them, by `backend` in
/// the end.
void PathSearch::finish(synthesis::Backend backend, const std::vector<PathMinimum>& in_order) {
  constexpr auto gauss_newton = synthesis::Backend::gauss_newton;
  refine_best(few_.coarse(), deepened_, gauss_newton, kDeepeningIterations, {0.7, 0.8});
  if (!many_.is_whole()) refine_at(few_, many_, {0.8, 0.85});
  if (!few_.is_whole()) {
    refine_at(many_.is_whole() ? few_ : many_, all_points_, {0.85, 0.9});
  }
  add_in_order(in_order);
  if (backend != gauss_newton) {
    refine_best(whole_, kFinished, backend, kFinishingIterations, {0.9, 1});
  }
  polish_best();
}

/// Adds minima of the same problem with its points in order, each at the places nearest to the
/// points in any order and refined there: none gets worse.
void PathSearch::add_in_order(const std::vector<PathMinimum>& minima) {
  std::vector<PathFound> added;
  for (const PathMinimum& minimum : minima) {
    if (added.size() == kept(kFinished)) break;
    PathFound found{.minimum = minimum, .valid = true, .fitted = true, .hits = 0};
    found.cost = minimum.solution.objective;
    PathFound nearest = found;
    if (whole_.solve.loss == synthesis::Loss::none) place_in_order(whole_, nearest);
    added.push_back(is_better(found, nearest) ? std::move(found) : std::move(nearest));
  }
  parallel_for(static_cast<int>(added.size()), run_.threads, [&](int index, int) {
    if (deadline_.reached()) return;
    refine(whole_, added[index], synthesis::Backend::gauss_newton,
           options(deadline_, finishing_iterations(whole_.points.size()), tolerance_, run_.seed));
  });
  count_work(added, whole_.points.size(), work_);
  std::ranges::move(added, std::back_inserter(all_));
  sort_and_merge(all_, is_better, kSameMinimum);
}

/// The last digits of the best, where they are met nearly.
void PathSearch::polish_best() {
  const std::size_t some = std::min(all_.size(), kept(kFinished));
  parallel_for(static_cast<int>(some), run_.threads, [&](int index, int) {
    if (deadline_.reached()) return;
    polish(whole_, all_[index], options(deadline_, kPolishingIterations, tolerance_, run_.seed));
  });
  count_work(all_, whole_.points.size(), work_);
  sort_and_merge(all_, is_better, kSameMinimum);
}

PathSearchResult PathSearch::take() {
  thoroughness_.best_hits = all_.empty() ? 0 : all_.front().hits;
  const auto seen_once = std::ranges::count_if(all_, [](const PathFound& found) {
    return found.hits <= 1 && found.minimum.solution.violation <= kPathFeasibility;
  });
  thoroughness_.unseen = chance_of_unseen(seen_once, independent_);
  PathSearchResult result{{}, thoroughness_};
  for (PathFound& found : all_) result.minima.push_back(std::move(found.minimum));
  return result;
}

}  // namespace

PathModel model_of(const PathProblem& scaled, const PathMinimum& minimum) {
  PathProblem confined = scaled;
  confined.constraints.required_class = minimum.confined_to;
  return PathModel(confined, minimum.assembly, minimum.clockwise);
}

PathSearchResult search_paths(const PathProblem& scaled, synthesis::Backend backend,
                              double tolerance, const Run& run, const Deadline& deadline,
                              Work& work) {
  std::vector<PathMinimum> in_order;
  Run last = run;
  if (scaled.order == PointOrder::any && scaled.timing != Timing::prescribed) {
    // What can be met in order can be met in any order, and often best so.
    PathProblem cyclic = scaled;
    cyclic.order = PointOrder::cyclic;
    Run first = run;
    if (run.progress) {
      first.progress = [&](double share, double best) { run.progress(0.5 * share, best); };
      last.progress = [&](double share, double best) { run.progress(0.5 + 0.5 * share, best); };
    }
    in_order = search_paths(cyclic, backend, tolerance, first, deadline, work).minima;
  }
  PathSearch search(scaled, tolerance, last, deadline, work);
  search.explore();
  search.finish(backend, in_order);
  return search.take();
}

}  // namespace cognate::problems
