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

synthesis::Options options(const Deadline& deadline, int iterations, double tolerance,
                           std::uint64_t seed) {
  return {.tolerance = tolerance,
          .feasibility = kFeasibility,
          .max_iterations = iterations,
          .time_limit = deadline.remaining(),
          .interrupted = deadline.flag(),
          .seed = seed};
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

/// By the loss that the problem asks for, a point's two residuals being one error.
Solution minimise(const PathProblem& problem, const PathModel& model, synthesis::Backend backend,
                  std::span<const double> start, const synthesis::Options& options) {
  const Solve& asked = problem.solve;
  return solve_by_loss(backend, model, asked.loss, asked.loss_scale, 2, start, options);
}

Found explore(const PathProblem& problem, const PathStarts& starts, std::mt19937_64 random,
              const Deadline& deadline) {
  Found found;
  const auto start = starts.draw(random, kCandidatesPerStart);
  if (!start) return found;
  found.minimum = {
      start->linkage.assembly, start->clockwise, confinement(problem, start->linkage), {}};
  const PathModel model = model_of(problem, found.minimum);
  found.minimum.solution = minimise(problem, model, synthesis::Backend::gauss_newton,
                                    model.variables_of(start->linkage, start->crank_angles),
                                    options(deadline, kExploringIterations, 1e-10, 0));
  found.add_work_of(found.minimum.solution);
  found.valid = found.minimum.solution.stop != synthesis::Stop::no_value;
  return found;
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
  refined.solution = minimise(problem, model, backend, found.minimum.solution.x, options);
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

void sort_and_merge(std::vector<Found>& all) {
  std::erase_if(all, [](const Found& found) { return !found.valid; });
  std::stable_sort(all.begin(), all.end(),
                   [](const Found& a, const Found& b) { return better(a.minimum, b.minimum); });
  std::vector<Found> distinct;
  for (Found& found : all) {
    const bool known = std::any_of(distinct.begin(), distinct.end(), [&](const Found& other) {
      return close(other.minimum, found.minimum);
    });
    if (!known) distinct.push_back(std::move(found));
  }
  all = std::move(distinct);
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
    all_[index] = explore(coarse, source, generator(run_.seed, index), deadline_);
    ++done;
    lower_best(all_[index]);
    if (thread == 0 && run_.progress) run_.progress(0.8 * done / starts, best_);
  });
  work_.candidates += static_cast<std::uint64_t>(done) * 2 * kCandidatesPerStart;
  work_.positions += work_.candidates * coarse.points.size();
  count(all_, coarse.points.size(), work_);
  sort_and_merge(all_);
}

/// Keeps `reserve` and twice the designs wanted, and goes on with those.
void PathSearch::refine_best(const PathProblem& problem, std::size_t reserve,
                             synthesis::Backend backend, int iterations, double share) {
  const std::size_t most = reserve + 2 * static_cast<std::size_t>(whole_.solve.designs);
  if (all_.size() > most) all_.resize(most);
  parallel_for(static_cast<int>(all_.size()), run_.threads, [&](int index, int thread) {
    if (deadline_.reached()) return;
    refine(problem, all_[index], backend, options(deadline_, iterations, tolerance_, run_.seed));
    if (thread == 0 && run_.progress) run_.progress(share, best_);
  });
  count(all_, problem.points.size(), work_);
  sort_and_merge(all_);
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
