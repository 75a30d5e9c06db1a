#include "problems/path/search.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "problems/path/explorer.hpp"
#include "problems/path/found.hpp"
#include "problems/path/problem.hpp"

namespace cognate::problems {
namespace {

/// At most some points of a problem in even steps, the first and last among them, and as many of
/// the points that alone are timed. A problem with fewer points stays as it is.
class PathCoarsening {
 public:
  PathCoarsening(const PathProblem& problem, std::size_t most);

  const PathProblem& coarse() const { return coarse_; }
  bool is_whole() const { return kept_.size() == whole_size_; }

  /// Those of the kept points out of crank angles at all points.
  std::vector<double> kept(const std::vector<double>& crank_angles) const;

  /// Crank angles at all points from those at the kept ones, linear in between.
  std::vector<double> interpolated(std::span<const double> crank_angles) const;

 private:
  std::size_t whole_size_;
  std::vector<std::size_t> kept_;
  PathProblem coarse_;
};

template <class T>
std::vector<T> pick(const std::vector<T>& all, const std::vector<std::size_t>& kept) {
  if (all.empty()) return {};
  std::vector<T> picked;
  for (const std::size_t i : kept) picked.push_back(all[i]);
  return picked;
}

/// At most `most` of them, the first and last among these.
std::vector<std::size_t> in_even_steps(const std::vector<std::size_t>& all, std::size_t most) {
  if (all.size() <= most) return all;
  std::vector<std::size_t> kept;
  for (std::size_t k = 0; k < most; ++k) {
    kept.push_back(all[k * (all.size() - 1) / (most - 1)]);
  }
  return kept;
}

PathCoarsening::PathCoarsening(const PathProblem& problem, std::size_t most)
    : whole_size_(problem.points.size()), coarse_(problem) {
  const bool thin = whole_size_ > most;
  std::vector<std::size_t> all(whole_size_), timed;
  std::iota(all.begin(), all.end(), std::size_t{0});
  kept_ = thin ? in_even_steps(all, most) : all;
  if (thin && problem.timing == Timing::mixed) {
    // A point that is timed says more than its neighbours.
    std::ranges::copy_if(all, std::back_inserter(timed),
                         [&](std::size_t j) { return problem.is_timed(j); });
    std::ranges::copy(in_even_steps(timed, most), std::back_inserter(kept_));
    std::ranges::sort(kept_);
    kept_.erase(std::unique(kept_.begin(), kept_.end()), kept_.end());
  }
  coarse_.points = pick(problem.points, kept_);
  coarse_.crank_angles = pick(problem.crank_angles, kept_);
  coarse_.has_crank_angle = pick(problem.has_crank_angle, kept_);
  coarse_.weights = pick(problem.weights, kept_);
}

std::vector<double> PathCoarsening::kept(const std::vector<double>& crank_angles) const {
  return pick(crank_angles, kept_);
}

std::vector<double> PathCoarsening::interpolated(std::span<const double> crank_angles) const {
  std::vector<double> all(whole_size_);
  all[kept_.front()] = crank_angles.front();
  for (std::size_t k = 0; k + 1 < kept_.size(); ++k) {
    // By the shorter way: neighbours are much less than half a turn apart.
    const double step = std::remainder(crank_angles[k + 1] - crank_angles[k], kTurn);
    const double gap = double(kept_[k + 1] - kept_[k]);
    for (std::size_t i = kept_[k]; i <= kept_[k + 1]; ++i) {
      all[i] = crank_angles[k] + step * double(i - kept_[k]) / gap;
    }
  }
  return all;
}

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
  return synthesis::until(deadline, {.tolerance = tolerance,
                                     .feasibility = 0.1 * kPathFeasibility,
                                     .max_iterations = iterations,
                                     .seed = seed});
}

/// From some of the points to more: the same linkage, its crank angles interpolated, or those at
/// which it comes nearest to the points in order. Any refinement counts as better.
void carry_over(const PathCoarsening& some, const PathCoarsening& more, PathFound& found) {
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
void refine(const PathProblem& problem, PathFound& found, synthesis::Solver solver,
            const synthesis::Options& options) {
  PathFound refined = found;
  refined.minimum.solution = minimise(problem, refined, solver, options);
  const bool lost = refined.minimum.solution.stop == synthesis::Stop::no_value;
  if (lost || is_better(found, refined)) refined.minimum = found.minimum;
  found = std::move(refined);
}

/// The stages of a search.
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
        work_(work),
        search_({}, {run.threads, deadline, run.progress}) {}

  void explore();
  void refine_best(const PathProblem& problem, std::size_t reserve, synthesis::Solver solver,
                   int iterations, synthesis::Shares shares);
  void finish(synthesis::Solver solver, const std::vector<PathMinimum>& in_order);
  void refine_at(const PathCoarsening& some, const PathCoarsening& more, synthesis::Shares shares);
  void add_in_order(const std::vector<PathMinimum>& minima);
  void polish_best();
  PathSearchResult take();

 private:
  std::size_t kept(std::size_t reserve) const {
    return reserve + 2 * static_cast<std::size_t>(whole_.solve.designs);
  }

  const PathProblem& whole_;
  PathCoarsening few_, many_, all_points_;
  std::size_t deepened_;
  double tolerance_;
  const Run& run_;
  const Deadline& deadline_;
  Work& work_;
  synthesis::MultiStart<PathRules> search_;
  int starts_ = 0;  ///< of the exploration
};

void PathSearch::explore() {
  Run run = run_;
  for (Design& design : run.known) design.crank_angles = few_.kept(design.crank_angles);
  ExploredPaths explored =
      explore_paths(few_.coarse(), {whole_.solve.starts, kept(deepened_), run}, deadline_, work_);
  starts_ = explored.starts;
  search_.all() = std::move(explored.minima);
}

/// Goes on with `reserve` and twice the designs wanted.
void PathSearch::refine_best(const PathProblem& problem, std::size_t reserve,
                             synthesis::Solver solver, int iterations, synthesis::Shares shares) {
  search_.keep(kept(reserve));
  search_.refine(shares, [&](PathFound& found) {
    refine(problem, found, solver, options(deadline_, iterations, tolerance_, run_.seed));
  });
  count_work(search_.all(), problem.points.size(), work_);
  search_.merge(kSameMinimum);
}

/// Goes on with the best at more points.
void PathSearch::refine_at(const PathCoarsening& some, const PathCoarsening& more,
                           synthesis::Shares shares) {
  search_.keep(kept(kFinished));
  for (PathFound& found : search_.all()) carry_over(some, more, found);
  const PathProblem& problem = more.coarse();
  refine_best(problem, kFinished, synthesis::Solver::gauss_newton,
              finishing_iterations(problem.points.size()), shares);
}

/// Brings the best to convergence at all points, and those `in_order` with them, by `solver` in
/// the end.
void PathSearch::finish(synthesis::Solver solver, const std::vector<PathMinimum>& in_order) {
  constexpr auto gauss_newton = synthesis::Solver::gauss_newton;
  refine_best(few_.coarse(), deepened_, gauss_newton, kDeepeningIterations, {0.7, 0.8});
  if (!many_.is_whole()) refine_at(few_, many_, {0.8, 0.85});
  if (!few_.is_whole()) {
    refine_at(many_.is_whole() ? few_ : many_, all_points_, {0.85, 0.9});
  }
  add_in_order(in_order);
  if (solver != gauss_newton) {
    refine_best(whole_, kFinished, solver, kFinishingIterations, {0.9, 1});
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
  search_.for_each(added.size(), [&](std::size_t i) {
    refine(whole_, added[i], synthesis::Solver::gauss_newton,
           options(deadline_, finishing_iterations(whole_.points.size()), tolerance_, run_.seed));
  });
  count_work(added, whole_.points.size(), work_);
  search_.add(std::move(added), kSameMinimum);
}

/// The last digits of the best, where they are met nearly.
void PathSearch::polish_best() {
  auto& all = search_.all();
  search_.for_each(std::min(all.size(), kept(kFinished)), [&](std::size_t i) {
    polish(whole_, all[i], options(deadline_, kPolishingIterations, tolerance_, run_.seed));
  });
  count_work(all, whole_.points.size(), work_);
  search_.merge(kSameMinimum);
}

PathSearchResult PathSearch::take() {
  PathSearchResult result{{}, search_.statistics(synthesis::kBestMinima)};
  result.statistics.starts = starts_;
  for (PathFound& found : search_.all()) result.minima.push_back(std::move(found.minimum));
  return result;
}

}  // namespace

PathModel model_of(const PathProblem& scaled, const PathMinimum& minimum) {
  PathProblem confined = scaled;
  confined.constraints.required_class = minimum.confined_to;
  return PathModel(confined, minimum.assembly, minimum.clockwise);
}

PathSearchResult search_paths(const PathProblem& scaled, synthesis::Solver solver, double tolerance,
                              const Run& run, const Deadline& deadline, Work& work) {
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
    in_order = search_paths(cyclic, solver, tolerance, first, deadline, work).minima;
  }
  PathSearch search(scaled, tolerance, last, deadline, work);
  search.explore();
  search.finish(solver, in_order);
  return search.take();
}

}  // namespace cognate::problems
