#include "problems/guidance/fit.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <random>
#include <span>
#include <utility>
#include <vector>

#include "problems/guidance/found.hpp"
#include "problems/guidance/order.hpp"
#include "problems/guidance/problem.hpp"
#include "problems/guidance/relaxations.hpp"
#include "problems/guidance/starts.hpp"
#include "problems/linkage/linkage_constraints.hpp"
#include "synthesis/search/multi_start.hpp"
#include "synthesis/search/search.hpp"

namespace cognate::problems {
namespace {

using synthesis::Solution;
using synthesis::Solver;

/// Iterations spent on every start, on the best ones, and on the best of these over all poses of a
/// long list or by a back end of the user's choice.
constexpr int kExploringIterations = 200;
constexpr int kDeepeningIterations = 1000;
constexpr int kFinishingIterations = 200;
/// How many explored starts are deepened, and how many of those finished, beyond twice the designs
/// wanted.
constexpr std::size_t kDeepened = 24, kFinished = 2;
/// How often a minimum is put in order, each time with fewer stations.
constexpr int kOrderingRounds = 6;
/// How often stations of a minimum are parted.
constexpr int kPartingRounds = 20;
/// How often the form of a minimum on the border of what closes changes, and how near to a dead
/// point stations are that are held there.
constexpr int kBorderRounds = 12;
constexpr double kNearDead = 0.1;
/// As a share of all links, by how much a linkage closes whose closing is then a constraint.
constexpr double kNearBorder = 0.02;
/// Starts of a round, and the fewest and most of a search where the file does not say: without and
/// with limits. From which start on those of a search with limits are also designs found,
/// disturbed.
constexpr int kRound = 100, kFewestStarts = 200, kMostStarts = 800;
constexpr int kFewestLimited = 400, kMostLimited = 1200, kFirstNearFound = 600;
/// Explored minima closer than this, and refined ones, are the same up to what an unfinished
/// refinement leaves open.
constexpr double kSameFit = 1e-4, kSameMinimum = 1e-6;

/// The stages of a search.
class MotionSearch {
 public:
  MotionSearch(const MotionProblem& scaled, double tolerance, const Run& run,
               const Deadline& deadline, Work& work)
      : whole_(scaled),
        kept_poses_(in_even_steps(scaled.poses.size())),
        coarse_(only(scaled, kept_poses_)),
        relaxed_(relaxations(coarse_)),
        tolerance_(tolerance),
        run_(run),
        deadline_(deadline),
        work_(work),
        search_({}, {run.threads, deadline, run.progress}) {}

  void explore(const std::vector<DyadPair>& known, std::optional<int> starts);
  void finish(Solver solver);
  MotionSearchResult take();

 private:
  synthesis::Options options(int iterations, double tolerance) const {
    return synthesis::until(deadline_, {.tolerance = tolerance,
                                        .feasibility = 0.1 * kMotionFeasibility,
                                        .max_iterations = iterations,
                                        .seed = run_.seed});
  }

  MotionFound explored(const MotionProblem& problem, MotionMinimum from);
  MotionFound explored(const MotionStart& start);
  MotionFound explored_in_turn(const MotionStart& start, int index);
  void fit(const MotionProblem& problem, Solver solver, const synthesis::Options& options,
           MotionMinimum& minimum);
  void put_in_order(const MotionProblem& problem, Solver solver, const synthesis::Options& options,
                    MotionFound& found);
  void confine(MotionMinimum& minimum) const;
  void part_stations(const MotionProblem& problem, Solver solver, const synthesis::Options& options,
                     MotionFound& found);
  bool improve(const MotionProblem& problem, Solver solver, const synthesis::Options& options,
               const std::optional<MotionForm>& form, std::span<const double> angles,
               MotionFound& found);
  void settle_on_border(const MotionProblem& problem, Solver solver,
                        const synthesis::Options& options, MotionFound& found);
  std::optional<MotionStart> near_found(int index) const;
  void add_known(const std::vector<DyadPair>& known);
  void add_round(const MotionStarts& starts, int first, int count);
  void add(std::vector<MotionFound> fresh) {
    search_.add(std::move(fresh), kSameFit);
    search_.keep(kept(kDeepened));
  }
  std::size_t kept(std::size_t reserve) const {
    return reserve + 2 * static_cast<std::size_t>(whole_.solve.designs);
  }
  void carry_over(MotionFound& found) const;
  void refine_best(const MotionProblem& problem, std::size_t reserve, Solver solver, int iterations,
                   synthesis::Shares shares);

  const MotionProblem& whole_;
  std::vector<std::size_t> kept_poses_;
  MotionProblem coarse_;
  std::vector<MotionProblem> relaxed_;  ///< of coarse_
  double tolerance_;
  const Run& run_;
  const Deadline& deadline_;
  Work& work_;
  synthesis::MultiStart<MotionRules> search_;
  synthesis::WorkCounter solved_;
};

MotionFound MotionSearch::explored(const MotionProblem& problem, MotionMinimum from) {
  MotionFound found{std::move(from), false};
  const auto exploring = options(kExploringIterations, 1e-10);
  fit(problem, Solver::gauss_newton, exploring, found.minimum);
  found.valid = found.minimum.solution.stop != synthesis::Stop::no_value;
  if (!found.valid) return found;
  found.violation = design_violation(problem, found.minimum);
  put_in_order(problem, Solver::gauss_newton, exploring, found);
  return found;
}

MotionFound MotionSearch::explored(const MotionStart& start) {
  MotionMinimum from = begun(coarse_, start);
  confine(from);
  return explored(coarse_, std::move(from));
}

/// Keeps a minimum to its class, where its crank does not turn fully and a limit of the
/// transmission angle is that of the part used: a descent that leaves it ends where other limits
/// hold, and many optima lie at its border.
void MotionSearch::confine(MotionMinimum& minimum) const {
  MotionForm& form = minimum.form;
  const bool is_link = form.second == synthesis::DyadKind::rr;
  if (!is_link || form.confined_to || !coarse_.constraints.transmission_angle) return;
  form.confined_to = open_class(coarse_.constraints,
                                lengths_of(MotionModel(coarse_, form).pair(minimum.solution.x)));
}

/// Every second start is explored with some limits dropped, each time others, and from there with
/// all of them: all limits together lead most starts to poor minima at their borders.
MotionFound MotionSearch::explored_in_turn(const MotionStart& start, int index) {
  if (relaxed_.empty() || index % 2 == 0) return explored(start);
  const MotionProblem& relaxed = relaxed_[static_cast<std::size_t>(index / 2) % relaxed_.size()];
  MotionFound there = explored(relaxed, begun(relaxed, start));
  if (!there.valid) return explored(start);
  MotionMinimum& minimum = there.minimum;
  const MotionModel without(relaxed, minimum.form);
  minimum.form.confined_to = form_of(coarse_, without.pair(minimum.solution.x)).confined_to;
  minimum.solution.x =
      MotionModel(coarse_, minimum.form)
          .with_angles(minimum.solution.x, without.station_angles(minimum.solution.x));
  confine(minimum);
  return explored(coarse_, std::move(minimum));
}

/// From the minimum's point; counts the work.
void MotionSearch::fit(const MotionProblem& problem, Solver solver,
                       const synthesis::Options& options, MotionMinimum& minimum) {
  const MotionModel model(problem, minimum.form);
  minimum.solution = solve(solver, model, minimum.solution.x, options);
  solved_.count(minimum.solution, problem.poses.size());
}

/// A minimum whose poses are out of order, or on two circuits, is fitted again with crank angles
/// that are not: neighbours that noise has exchanged share one, until no two are exchanged.
void MotionSearch::put_in_order(const MotionProblem& problem, Solver solver,
                                const synthesis::Options& options, MotionFound& found) {
  const Constraints& constraints = problem.constraints;
  if (!constraints.no_order_defect && !constraints.no_circuit_defect) return;
  MotionFound ordered = found;
  for (int round = 0; round < kOrderingRounds && ordered.violation > 0; ++round) {
    if (deadline_.reached()) return;
    auto next = in_order(problem, {ordered.minimum.form, ordered.minimum.solution.x});
    if (!next) return;
    ordered.minimum.form = std::move(next->form);
    ordered.minimum.solution.x = std::move(next->x);
    fit(problem, solver, options, ordered.minimum);
    if (ordered.minimum.solution.stop == synthesis::Stop::no_value) return;
    ordered.violation = design_violation(problem, ordered.minimum);
    if (ordered.violation < found.violation) found = ordered;
  }
}

/// A minimum in order whose poses share crank angles that they no longer need to share: once
/// pooled, they are parted again as long as that lowers the error.
void MotionSearch::part_stations(const MotionProblem& problem, Solver solver,
                                 const synthesis::Options& options, MotionFound& found) {
  for (int round = 0; round < kPartingRounds && found.violation == 0; ++round) {
    if (deadline_.reached()) return;
    auto next = parted(problem, {found.minimum.form, found.minimum.solution.x});
    if (!next) return;
    MotionFound apart = found;
    apart.minimum.form = std::move(next->form);
    apart.minimum.solution.x = std::move(next->x);
    fit(problem, solver, options, apart.minimum);
    if (apart.minimum.solution.stop == synthesis::Stop::no_value) return;
    apart.violation = design_violation(problem, apart.minimum);
    put_in_order(problem, solver, options, apart);
    if (apart.violation > 0 || !is_better(apart.minimum, found.minimum)) return;
    found = std::move(apart);
  }
}

/// Whether a fit in another form, from the same dimensions and these crank angles, is better; it
/// then takes the place of `found`.
bool MotionSearch::improve(const MotionProblem& problem, Solver solver,
                           const synthesis::Options& options, const std::optional<MotionForm>& form,
                           std::span<const double> angles, MotionFound& found) {
  if (!form || deadline_.reached()) return false;
  MotionFound other = found;
  other.minimum.form = *form;
  other.minimum.solution.x =
      MotionModel(problem, *form).with_angles(found.minimum.solution.x, angles);
  fit(problem, solver, options, other.minimum);
  if (other.minimum.solution.stop == synthesis::Stop::no_value) return false;
  other.violation = design_violation(problem, other.minimum);
  if (other.violation > 0 || !is_better(other.minimum, found.minimum)) return false;
  found = std::move(other);
  return true;
}

/// A minimum on the border of what closes: a descent creeps along it, since beside a dead point
/// the body turns without the crank. Stations there are held, and given up again where their poses
/// would be nearer before the dead point; what would open between stations is kept closed; as long
/// as one of these lowers the error.
void MotionSearch::settle_on_border(const MotionProblem& problem, Solver solver,
                                    const synthesis::Options& options, MotionFound& found) {
  for (int round = 0; round < kBorderRounds && found.violation == 0; ++round) {
    const std::vector<double> x = found.minimum.solution.x;
    const MotionModel model(problem, found.minimum.form);
    const std::vector<double> angles = model.station_angles(x);
    const auto improves = [&](const std::optional<MotionForm>& form) {
      return improve(problem, solver, options, form, angles, found);
    };
    if (const auto pressed = model.pressed_inwards(x)) {
      std::vector<double> apart = angles;
      const auto form = model.released(x, *pressed, apart);
      if (improve(problem, solver, options, form, apart, found)) continue;
    }
    if (improves(model.kept_closed(x, kNearBorder))) continue;
    if (!improves(model.with_held(x, kNearDead))) return;
  }
}

void MotionSearch::explore(const std::vector<DyadPair>& known, std::optional<int> starts) {
  add_known(known);
  std::optional<MotionStarts> source;
  if (starts != 0) source.emplace(coarse_, kept_poses_, run_.seed, deadline_);
  const bool limited = !relaxed_.empty();
  search_.explore({.starts = starts,
                   .round = kRound,
                   .fewest = limited ? kFewestLimited : kFewestStarts,
                   .most = limited ? kMostLimited : kMostStarts},
                  {0, 0.8}, [&](int first, int count) { add_round(*source, first, count); });
}

/// Late in a search with limits every second start is a design found, disturbed: at borders where
/// several limits meet, descents end short of the best, each elsewhere.
std::optional<MotionStart> MotionSearch::near_found(int index) const {
  const auto& all = search_.all();
  if (relaxed_.empty() || all.empty() || index < kFirstNearFound || index % 2 == 0) return {};
  std::mt19937_64 random = synthesis::start_random(run_.seed, index);
  const auto& [form, origin, solution] = all[random() % all.size()].minimum;
  if (form.second != synthesis::DyadKind::rr) return {};
  return MotionStart{disturbed(coarse_, MotionModel(coarse_, form).pair(solution.x), random),
                     "search"};
}

void MotionSearch::add_known(const std::vector<DyadPair>& known) {
  std::vector<MotionFound> fresh(known.size());
  search_.for_each(known.size(), [&](std::size_t i) {
    fresh[i] = explored({known[i], "search"});
    fresh[i].hits = 0;  // no start of the search
  });
  add(std::move(fresh));
}

void MotionSearch::add_round(const MotionStarts& starts, int first, int count) {
  std::vector<MotionFound> fresh(static_cast<std::size_t>(count));
  std::atomic<int> done{0};
  search_.for_each(fresh.size(), [&](std::size_t i) {
    const int index = first + static_cast<int>(i);
    if (const auto near = near_found(index)) {
      fresh[i] = explored(*near);
      fresh[i].hits = 0;  // no draw of its own
      ++done;
      return;
    }
    const auto start = starts.start(index);
    if (!start) return;
    fresh[i] = explored_in_turn(*start, index);
    ++done;
  });
  work_.candidates += static_cast<std::uint64_t>(done);
  add(std::move(fresh));
}

/// From the kept poses to all: the same dyads, their sides looked at anew.
void MotionSearch::carry_over(MotionFound& found) const {
  const DyadPair pair = MotionModel(coarse_, found.minimum.form).pair(found.minimum.solution.x);
  MotionForm form = form_of(whole_, pair);
  form.confined_to = found.minimum.form.confined_to;
  const auto& coarse_sides = found.minimum.form.sides;
  const bool one_side =
      std::ranges::count(coarse_sides, coarse_sides.front()) == std::ssize(coarse_sides);
  if (one_side) std::ranges::fill(form.sides, coarse_sides.front());
  found.minimum.form = form;
  const MotionModel whole(whole_, form);
  Solution& solution = found.minimum.solution;
  solution.x = whole.variables_of(pair);
  std::vector<double> residuals(static_cast<std::size_t>(whole.residual_count()));
  solution.objective = found.violation = std::numeric_limits<double>::infinity();
  if (!whole.residuals(solution.x, residuals, {}, {})) return;
  solution.objective =
      std::inner_product(residuals.begin(), residuals.end(), residuals.begin(), 0.0);
  found.violation = design_violation(whole_, found.minimum);
}

/// Keeps `reserve` and twice the designs wanted, and goes on with those; what is reached replaces
/// them unless it is worse.
void MotionSearch::refine_best(const MotionProblem& problem, std::size_t reserve, Solver solver,
                               int iterations, synthesis::Shares shares) {
  search_.keep(kept(reserve));
  search_.refine(shares, [&](MotionFound& found) {
    const auto refining = options(iterations, tolerance_);
    MotionFound refined = found;
    fit(problem, solver, refining, refined.minimum);
    if (refined.minimum.solution.stop == synthesis::Stop::no_value) return;
    refined.violation = design_violation(problem, refined.minimum);
    put_in_order(problem, solver, refining, refined);
    part_stations(problem, solver, refining, refined);
    settle_on_border(problem, solver, refining, refined);
    if (!is_worse(refined, found)) found = std::move(refined);
  });
  search_.merge(kSameMinimum);
}

/// Brings the best to convergence at all poses, by `solver` in the end.
void MotionSearch::finish(Solver solver) {
  refine_best(coarse_, kDeepened, Solver::gauss_newton, kDeepeningIterations, {0.8, 0.9});
  if (kept_poses_.size() < whole_.poses.size()) {
    search_.keep(kept(kFinished));
    for (MotionFound& found : search_.all()) carry_over(found);
    refine_best(whole_, kFinished, Solver::gauss_newton, kFinishingIterations, {0.9, 0.95});
  }
  if (solver != Solver::gauss_newton) {
    refine_best(whole_, kFinished, solver, kFinishingIterations, {0.95, 1});
  }
}

MotionSearchResult MotionSearch::take() {
  auto& all = search_.all();
  std::erase_if(all, [](const MotionFound& found) {
    return !std::isfinite(found.minimum.solution.objective);  // does not close at every pose
  });
  work_.positions += solved_.total().evaluations;
  work_.gradients += solved_.total().gradients;
  work_.solver_iterations += solved_.total().iterations;
  MotionSearchResult result{{}, search_.statistics(synthesis::kBestMinima)};
  for (MotionFound& found : all) result.minima.push_back(std::move(found.minimum));
  return result;
}

}  // namespace

MotionSearchResult search_motions(const MotionProblem& scaled, const std::vector<DyadPair>& known,
                                  std::optional<int> starts, Solver solver, double tolerance,
                                  const Run& run, const Deadline& deadline, Work& work) {
  MotionSearch search(scaled, tolerance, run, deadline, work);
  search.explore(known, starts);
  search.finish(solver);
  return search.take();
}

}  // namespace cognate::problems
