#include "problems/path_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>

#include "analysis/mobility.hpp"
#include "analysis/parallel.hpp"
#include "problems/path_starts.hpp"
#include "problems/path_thinning.hpp"

namespace cognate::problems {
namespace {

using synthesis::Solution;

/// Designs screened for each start that is refined: enough that the linear unknowns alone have
/// found the basin in most cases, few enough that screening costs less than refining.
constexpr std::size_t kCandidatesPerStart = 256;
/// Iterations spent on every start. The best of the library's problems are within 1 % of their
/// minimum after 60; the rest of a long valley is walked by the best ones only.
constexpr int kExploringIterations = 80;
constexpr int kDeepeningLaneIterations = 600;
constexpr int kDeepeningIterations = 2000;
constexpr int kFinishingIterations = 200;
/// How many explored starts are deepened, and how many of those are finished at all points of a
/// long list and by a back end of the user's choice, beyond twice the designs wanted.
constexpr std::size_t kDeepened = 64;
constexpr std::size_t kFinished = 2;
constexpr double kFeasibility = 1e-9;

struct Found {
  PathMinimum minimum;
  bool valid = false;
  double cost = 0;  ///< of a fit in lanes: objective and penalties
  /// Work not yet counted, that of refinements which were no better among it.
  std::uint64_t evaluations = 0, gradients = 0, iterations = 0;

  void add_work_of(const Solution& solution) {
    evaluations += solution.evaluations;
    gradients += solution.gradients;
    iterations += static_cast<std::uint64_t>(solution.iterations);
  }
};

std::mt19937_64 generator(std::uint64_t seed, int start) {
  std::seed_seq sequence{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32),
                         static_cast<std::uint32_t>(start)};
  return std::mt19937_64(sequence);
}

bool better(const PathMinimum& a, const PathMinimum& b) {
  const bool a_feasible = a.solution.violation <= kFeasibility;
  const bool b_feasible = b.solution.violation <= kFeasibility;
  if (a_feasible != b_feasible) return a_feasible;
  if (!a_feasible) return a.solution.violation < b.solution.violation;
  return a.solution.objective < b.solution.objective;
}

/// Whether two minima are the same point up to what an unfinished refinement leaves open.
bool close(const PathMinimum& a, const PathMinimum& b) {
  if (a.assembly != b.assembly || a.clockwise != b.clockwise) return false;
  if (a.confined_to != b.confined_to) return false;
  for (std::size_t i = 0; i < a.solution.x.size(); ++i) {
    const double difference = std::abs(a.solution.x[i] - b.solution.x[i]);
    if (difference > 1e-6 * (1 + std::abs(a.solution.x[i]))) return false;
  }
  return true;
}

synthesis::Options options(const Deadline& deadline, int iterations, double tolerance) {
  return {.tolerance = tolerance,
          .feasibility = kFeasibility,
          .max_iterations = iterations,
          .time_limit = deadline.remaining(),
          .interrupted = deadline.flag()};
}

std::optional<RequiredClass> confinement(const PathProblem& problem, const FourBar& start) {
  const Constraints& constraints = problem.constraints;
  const bool open =
      !constraints.required_class || *constraints.required_class == RequiredClass::grashof;
  if (open && constraints.transmission_angle) {
    const MobilityClass mobility = mobility_class(lengths(start));
    if (mobility == MobilityClass::crank_rocker) return RequiredClass::crank_rocker;
    if (mobility == MobilityClass::double_crank) return RequiredClass::double_crank;
  }
  return constraints.required_class;
}

/// What a draw starts from, before it is fitted.
Found drawn(const PathProblem& problem, const PathStarts& starts, std::mt19937_64 random) {
  Found found;
  const auto start = starts.draw(random, kCandidatesPerStart);
  if (!start) return found;
  found.minimum = {
      start->linkage.assembly, start->clockwise, confinement(problem, start->linkage), {}};
  found.minimum.solution.x =
      model_of(problem, found.minimum).variables_of(start->linkage, start->crank_angles);
  found.valid = true;
  return found;
}

/// The point where a fit in lanes has ended, as `model` sees it.
void take_over(const PathModel& model, const synthesis::PathFitState& state, Found& found) {
  Solution& solution = found.minimum.solution;
  solution.x = model.variables_of(state, solution.x);
  found.cost = state.cost;
  found.evaluations += 2 * static_cast<std::uint64_t>(state.iterations);
  found.gradients += static_cast<std::uint64_t>(state.iterations);
  found.iterations += static_cast<std::uint64_t>(state.iterations);
  std::vector<double> residuals(model.residual_count()), limits(model.constraint_count());
  found.valid = std::isfinite(state.cost) && model.residuals(solution.x, residuals, {}, {});
  if (!found.valid) return;
  solution.objective = 0;
  for (const double r : residuals) solution.objective += r * r;
  model.constraints(solution.x, limits, {});
  solution.violation = 0;
  for (const double c : limits) solution.violation = std::max(solution.violation, -c);
}

/// Fits those of `all` that are valid in SIMD lanes; those confined to one class share one problem.
void fit_in_lanes(const PathProblem& problem, std::span<Found> all,
                  const synthesis::PathFitOptions& options) {
  std::vector<Found*> left;
  for (Found& found : all) {
    if (found.valid) left.push_back(&found);
  }
  while (!left.empty()) {
    const auto confined_to = left.front()->minimum.confined_to;
    const auto others = std::stable_partition(left.begin(), left.end(), [&](const Found* found) {
      return found->minimum.confined_to == confined_to;
    });
    std::vector<synthesis::PathFitState> states;
    for (auto it = left.begin(); it != others; ++it) {
      const PathMinimum& minimum = (*it)->minimum;
      states.push_back(model_of(problem, minimum).lane_state(minimum.solution.x));
    }
    fit_paths(model_of(problem, left.front()->minimum).lane_fit(), states, options);
    for (std::size_t i = 0; i < states.size(); ++i) {
      take_over(model_of(problem, left[i]->minimum), states[i], *left[i]);
    }
    left.erase(left.begin(), others);
  }
}

/// From the kept points to all: the same linkage, its crank angles interpolated. Its objective is
/// that of the kept points until it is refined, so whatever refinement gives counts as better.
void carry_over(const PathThinning& thinning, const PathProblem& whole, Found& found) {
  const PathModel coarse = model_of(thinning.coarse(), found.minimum);
  const PathModel fine = model_of(whole, found.minimum);
  Solution& solution = found.minimum.solution;
  const FourBar linkage = coarse.linkage(solution.x);
  solution.x = fine.variables_of(linkage, thinning.interpolated(coarse.crank_angles(solution.x)));
  solution.objective = std::numeric_limits<double>::infinity();
}

/// Goes on from `found` and keeps what is reached unless it is worse.
void refine(const PathProblem& problem, Found& found, synthesis::Backend backend,
            const synthesis::Options& options) {
  const PathModel model = model_of(problem, found.minimum);
  PathMinimum refined = found.minimum;
  refined.solution = solve(backend, model, found.minimum.solution.x, options);
  found.add_work_of(refined.solution);
  if (refined.solution.stop != synthesis::Stop::no_value && !better(found.minimum, refined)) {
    found.minimum = std::move(refined);
  }
}

void count(std::vector<Found>& all, std::size_t points, Work& work) {
  for (Found& found : all) {
    work.positions += std::exchange(found.evaluations, 0) * points;
    work.gradients += std::exchange(found.gradients, 0) * points;
    work.solver_iterations += std::exchange(found.iterations, 0);
  }
}

/// Sorts by `before` and drops those that are `close` to an earlier one.
template <class Before>
void sort_and_merge(std::vector<Found>& all, const Before& before) {
  std::erase_if(all, [](const Found& found) { return !found.valid; });
  std::ranges::stable_sort(all, before);
  std::vector<Found> distinct;
  for (Found& found : all) {
    const bool known = std::any_of(distinct.begin(), distinct.end(), [&](const Found& other) {
      return close(other.minimum, found.minimum);
    });
    if (!known) distinct.push_back(std::move(found));
  }
  all = std::move(distinct);
}

bool is_better(const Found& a, const Found& b) {
  return better(a.minimum, b.minimum);
}

bool costs_less(const Found& a, const Found& b) {
  return a.cost < b.cost;
}

/// The stages of a search; each works on `all_` in place.
class PathSearch {
 public:
  PathSearch(const PathProblem& scaled, double tolerance, const Run& run, const Deadline& deadline,
             Work& work)
      : whole_(scaled),
        thinning_(scaled),
        tolerance_(tolerance),
        run_(run),
        deadline_(deadline),
        work_(work) {}

  void explore_all(int starts);
  void keep(std::size_t reserve);
  void refine_best(const PathProblem& problem, std::size_t reserve, synthesis::Backend backend,
                   int iterations, double share);
  void finish(synthesis::Backend backend);
  std::vector<PathMinimum> take();

 private:
  void lower_best(const Found& found);

  const PathProblem& whole_;
  PathThinning thinning_;
  double tolerance_;
  const Run& run_;
  const Deadline& deadline_;
  Work& work_;
  std::vector<Found> all_;
  std::atomic<double> best_{std::numeric_limits<double>::infinity()};  ///< for progress only
};

void PathSearch::lower_best(const Found& found) {
  if (!found.valid || found.minimum.solution.violation > kFeasibility) return;
  const double objective = found.minimum.solution.objective;
  double known = best_;
  while (objective < known && !best_.compare_exchange_weak(known, objective)) {
  }
}

void PathSearch::explore_all(int starts) {
  const PathProblem& coarse = thinning_.coarse();
  const PathStarts source(coarse);
  all_.resize(static_cast<std::size_t>(starts));
  std::atomic<int> done{0};
  parallel_for(starts, run_.threads, [&](int index, int thread) {
    if (deadline_.reached()) return;
    all_[index] = drawn(coarse, source, generator(run_.seed, index));
    ++done;
    if (thread == 0 && run_.progress) run_.progress(0.3 * done / starts, best_);
  });
  work_.candidates += static_cast<std::uint64_t>(done) * 2 * kCandidatesPerStart;
  work_.positions += work_.candidates * coarse.points.size();
  synthesis::PathFitOptions fit{.most_iterations = kExploringIterations,
                                .threads = run_.threads,
                                .stop = [this] { return deadline_.reached(); }};
  fit_in_lanes(coarse, all_, fit);
  sort_and_merge(all_, costs_less);
  fit.most_iterations = kDeepeningLaneIterations;
  fit.tolerance = 1e-13;
  keep(kDeepened);
  fit_in_lanes(coarse, all_, fit);
  count(all_, coarse.points.size(), work_);
  sort_and_merge(all_, costs_less);
}

/// Keeps `reserve` and twice the designs wanted.
void PathSearch::keep(std::size_t reserve) {
  const std::size_t most = reserve + 2 * static_cast<std::size_t>(whole_.solve.designs);
  if (all_.size() > most) all_.resize(most);
}

/// Goes on with `reserve` and twice the designs wanted.
void PathSearch::refine_best(const PathProblem& problem, std::size_t reserve,
                             synthesis::Backend backend, int iterations, double share) {
  keep(reserve);
  parallel_for(static_cast<int>(all_.size()), run_.threads, [&](int index, int thread) {
    if (deadline_.reached()) return;
    refine(problem, all_[index], backend, options(deadline_, iterations, tolerance_));
    if (thread == 0 && run_.progress) run_.progress(share, best_);
  });
  count(all_, problem.points.size(), work_);
  for (const Found& found : all_) lower_best(found);
  sort_and_merge(all_, is_better);
}

/// Brings the best to convergence at all points, by `backend` in the end.
void PathSearch::finish(synthesis::Backend backend) {
  constexpr auto gauss_newton = synthesis::Backend::gauss_newton;
  refine_best(thinning_.coarse(), kDeepened, gauss_newton, kDeepeningIterations, 0.8);
  if (!thinning_.is_whole()) {
    for (Found& found : all_) carry_over(thinning_, whole_, found);
    refine_best(whole_, kFinished, gauss_newton, kFinishingIterations, 0.9);
  }
  if (backend != gauss_newton) {
    refine_best(whole_, kFinished, backend, kFinishingIterations, 0.95);
  }
}

std::vector<PathMinimum> PathSearch::take() {
  std::vector<PathMinimum> minima;
  for (Found& found : all_) minima.push_back(std::move(found.minimum));
  return minima;
}

}  // namespace

PathModel model_of(const PathProblem& scaled, const PathMinimum& minimum) {
  PathProblem confined = scaled;
  confined.constraints.required_class = minimum.confined_to;
  return PathModel(confined, minimum.assembly, minimum.clockwise);
}

std::vector<PathMinimum> search_paths(const PathProblem& scaled, int starts,
                                      synthesis::Backend backend, double tolerance, const Run& run,
                                      const Deadline& deadline, Work& work) {
  PathSearch search(scaled, tolerance, run, deadline, work);
  search.explore_all(starts);
  search.finish(backend);
  return search.take();
}

}  // namespace cognate::problems
