#include "problems/path/explorer.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <span>
#include <utility>

#include "analysis/numbers/parallel.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/path/deviation_between_samples.hpp"
#include "problems/path/exact/starts.hpp"
#include "problems/path/lane_fits.hpp"
#include "problems/path/order.hpp"
#include "problems/path/starts.hpp"
#include "synthesis/search/search.hpp"

namespace cognate::problems {
namespace {

using synthesis::Solution;

/// Designs screened for each start that is refined: enough that the linear unknowns alone have
/// found the basin in most cases, few enough that screening costs less than refining.
constexpr std::size_t kCandidatesPerStart = 256;
/// The same for every other start of a problem with limits. Screening knows the limits on lengths
/// alone: the best of many candidates lie where the curve would be nearest without the others, and
/// none of them may lie where it is nearest within all.
constexpr std::size_t kFewCandidates = 4;
/// Iterations spent on every start. The best of the library's problems are within 1 % of their
/// minimum after 60; the rest of a long valley is walked by the best ones only.
constexpr int kExploringIterations = 80;
constexpr double kExploringTolerance = 1e-10;
constexpr int kDeepenedFitIterations = 600;
/// With limits over the turn, whose evaluation costs more than that of most points.
constexpr int kLimitedIterations = 120;
/// Where order binds, as each evaluation places all points anew.
constexpr int kOrderedIterations = 60;
constexpr double kDeepeningTolerance = 1e-13;
/// Starts of a round, and the fewest and most of a search where the file does not say. The best
/// minimum of the library's problems attracts one start in forty or more: 250 starts miss it from
/// one seed in a hundred or so, 500 from none.
constexpr int kRound = 250, kFewestStarts = 500, kMostStarts = 6000;
/// The most where every start is fitted by itself under all limits, or the points have been met in
/// order before, the most where half of them are, and times how many points otherwise: what a
/// search may cost.
constexpr int kMostLimitedStarts = 1000, kMostHalfLimitedStarts = 5000;
constexpr int kMostStartsTimesPoints = 120'000;
/// A search goes on until it has drawn so many times the starts after which its best was found.
constexpr int kPatience = 3;
/// …and until at most this is the estimated chance that a minimum like the best was missed.
constexpr double kDoubt = 0.1;
/// About how many of the best designs starts are drawn, once there are any.
constexpr std::size_t kKnownPaths = 12;
/// Fits that end with costs equal to their last six digits or so are this far apart.
constexpr double kSameFit = 1e-4;

// For progress: the exploration's share of the search, and where in a round its starts have been
// drawn and fitted.
constexpr double kExplored = 0.7, kDrawn = 0.2, kFitted = 0.7;

/// Whether the transmission angle is limited over the way of a crank that does not turn fully.
bool limits_way(const PathProblem& problem) {
  const Constraints& constraints = problem.constraints;
  return constraints.transmission_angle && !turns_fully(constraints.required_class);
}

/// Whether more is demanded than soundness and what screening knows, the limits on lengths.
bool is_limited(const PathProblem& problem) {
  const Constraints& limits = problem.constraints;
  const Bounds& bounds = problem.bounds;
  return limits.required_class || limits.transmission_angle || limits.link_ratio_max ||
         limits.time_ratio || limits.pivot_region || limits_turn(limits) || bounds.frame_angle ||
         bounds.pivot_a || bounds.pivot_d || bounds.coupler_point;
}

/// The rounds of an exploration.
class Explorer {
 public:
  Explorer(const PathProblem& problem, const PathExploration& exploration, const Deadline& deadline,
           Work& work)
      : problem_(problem),
        source_(problem),
        deviation_(problem),
        exploration_(exploration),
        deadline_(deadline),
        work_(work),
        search_({.by_cost = true}, {exploration.run.threads, deadline, exploration.run.progress}) {
    fit_.threads = exploration.run.threads;
    fit_.stop = [this] { return deadline_.reached(); };
  }

  ExploredPaths take() {
    const synthesis::StartRule rule{.starts = exploration_.starts,
                                    .round = kRound,
                                    .fewest = kFewestStarts,
                                    .most = most_starts(),
                                    .patience = kPatience,
                                    .doubt = kDoubt};
    add_known();
    search_.explore(
        rule, {0, kExplored}, [&](int first, int count) { add_round(first, count); },
        [&] { return is_met() || search_.best_is_known(rule); });
    if (!exploration_.starts) add_exact();
    return {std::move(search_.all()), search_.starts()};
  }

 private:
  int most_starts() const {
    if (!knows_lanes_ || problem_.order == PointOrder::any) return kMostLimitedStarts;
    const int affordable = kMostStartsTimesPoints / static_cast<int>(problem_.points.size());
    return std::clamp(affordable, kMostLimitedStarts,
                      places_ && limits_part_ ? kMostHalfLimitedStarts : kMostStarts);
  }

  void add_round(int first, int count) {
    const Run& run = exploration_.run;
    std::vector<PathFound> fresh(static_cast<std::size_t>(count));
    const std::vector<PathStarts::KnownPath> known = known_paths();
    const auto draw = [&](std::size_t i) {
      const int index = first + static_cast<int>(i);
      std::mt19937_64 random = synthesis::start_random(run.seed, index);
      const bool about = !known.empty() && random() % 2 == 0;
      const bool near = about && random() % 2 == 0;
      const auto start =
          source_.draw(random, near ? kFewCandidates : candidates(index),
                       about ? &known[random() % known.size()] : nullptr,
                       near ? PathStarts::Likeness::proportions : PathStarts::Likeness::timing);
      if (start) fresh[i] = placed(problem_, *start);
      if (about) fresh[i].hits = 0;  // says nothing of how easily its minimum is found
    };
    search_.for_each(fresh.size(), draw, {0, kDrawn});
    std::uint64_t screened = 0;
    for (int index = 0; index < count; ++index) screened += 2 * candidates(first + index);
    work_.candidates += screened;
    work_.positions += screened * problem_.points.size();
    add(std::move(fresh));
  }

  /// The best so far, where the crank angles of all points are free.
  std::vector<PathStarts::KnownPath> known_paths() const {
    std::vector<PathStarts::KnownPath> known;
    if (problem_.timing != Timing::free) return known;
    const PathFound* last = nullptr;  // of each valley the best
    for (const PathFound& found : search_.all()) {
      if (known.size() == kKnownPaths || found.strays) break;
      if (last && search_.rules().lie_in_one_valley(*last, found)) continue;
      last = &found;
      const auto& minimum = found.minimum;
      const PathModel model = model_of(problem_, minimum);
      const FourBar linkage = model.linkage(minimum.solution.x);
      std::vector<double> angles = model.crank_angles(minimum.solution.x);
      const double phase = angles.front() - frame_angle(linkage);
      known.push_back({{std::move(angles), minimum.clockwise}, lengths(linkage), phase});
    }
    return known;
  }

  /// How many designs are screened for a start.
  std::size_t candidates(int start) const {
    return is_limited_ && start % 2 == 1 ? kFewCandidates : kCandidatesPerStart;
  }

  /// Linkages through nine of the points, where the search has not met all of them.
  void add_exact() {
    const auto& all = search_.all();
    const bool met = !all.empty() && all.front().cost < kMetExactly;
    if (met || !has_exact_starts(problem_) || deadline_.reached()) return;
    std::vector<PathFound> fresh;
    for (const PathStart& start : exact_starts(problem_, exploration_.run, deadline_)) {
      fresh.push_back(placed(problem_, start));
      fresh.back().minimum.from_exact = true;
      fresh.back().hits = 0;  // no start of the search
    }
    place_in_order(fresh);
    add(std::move(fresh));
  }

  bool may_count(bool clockwise) const {
    const bool increments =
        problem_.timing != Timing::free && problem_.crank_reference == CrankReference::first;
    if (!increments) return !clockwise;
    return problem_.crank_sense != (clockwise ? CrankSense::ccw : CrankSense::cw);
  }

  /// Designs that the run begins with, by each sense of increments that there may be.
  void add_known() {
    std::vector<PathFound> fresh;
    for (const Design& design : exploration_.run.known) {
      for (const bool clockwise : {false, true}) {
        if (!may_count(clockwise)) continue;
        fresh.push_back(placed(problem_, {four_bar(design), design.crank_angles, clockwise}));
        fresh.back().hits = 0;
      }
    }
    if (!fresh.empty()) add(std::move(fresh));
  }

  void add(std::vector<PathFound> fresh) {
    fit_.most_iterations = kExploringIterations;
    fit_.tolerance = kExploringTolerance;
    // Half of the starts stay in their class, at whose border many optima lie: a descent that
    // leaves it ends where other limits hold. And half of both kinds, points not being timed, are
    // fitted within the limits on the way, of which the lanes know nothing: what is found without
    // them may hide better minima within them.
    for (std::size_t i = 0; limits_part_ && i < fresh.size(); ++i) {
      if (i % 8 < 4) confine(fresh[i]);
      fresh[i].binds = places_ && i % 4 < 2 && !turns_fully(fresh[i].minimum.confined_to);
    }
    fit(fresh, {kDrawn, kFitted}, false);
    search_.add(std::move(fresh), kSameFit);
    deepen();
  }

  /// Keeps a start to the class that it is in. A descent without that limit may end where the crank
  /// turns fully, of which the limits on the way say nothing.
  void confine(PathFound& found) const {
    if (!found.valid || turns_fully(found.minimum.confined_to)) return;
    const PathModel model = model_of(problem_, found.minimum);
    const auto own =
        open_class(problem_.constraints, lengths(model.linkage(found.minimum.solution.x)));
    if (own) found.minimum.confined_to = own;
  }

  /// Fits the best to their end and keeps them.
  void deepen() {
    search_.keep(exploration_.kept);
    auto& all = search_.all();
    const auto done =
        std::stable_partition(all.begin(), all.end(), std::not_fn(&PathFound::deepened));
    fit_.most_iterations =
        limits_turn(problem_.constraints) ? kLimitedIterations : kDeepenedFitIterations;
    fit_.tolerance = kDeepeningTolerance;
    deepen({all.begin(), done});
    for (auto it = all.begin(); it != done; ++it) it->deepened = true;
    search_.merge(kSameFit);
  }

  /// With free timing a fit that has left the order, and is worse once its points are back in it,
  /// is taken back and done in order. Between timed points the way out of the order and back leads
  /// to minima that are not reached within it.
  void deepen(std::span<PathFound> some) {
    if (problem_.timing != Timing::free || !assigns_places(problem_)) {
      fit(some, {kFitted, 1}, true);
      return;
    }
    place_in_order(some);
    std::vector<PathFound> before(some.begin(), some.end());
    fit(some, {kFitted, 1}, true);
    std::vector<std::size_t> lost;
    for (std::size_t i = 0; i < some.size(); ++i) {
      if (before[i].valid && !before[i].binds && (!some[i].valid || costs_less(before[i], some[i])))
        lost.push_back(i);
    }
    std::vector<PathFound> again;
    for (const std::size_t i : lost) {
      again.push_back(std::move(before[i]));
      again.back().binds = true;
    }
    fit_one_by_one(again, {kFitted, 1});
    count_work(again, problem_.points.size(), work_);
    for (std::size_t k = 0; k < lost.size(); ++k) some[lost[k]] = std::move(again[k]);
  }

  /// `part`: of the round, between which progress is reported. Points between timed ones are placed
  /// in order after half of the first fits alone: it leads some away from minima within reach.
  void fit(std::span<PathFound> some, synthesis::Shares part, bool deepening) {
    const auto others = std::stable_partition(
        some.begin(), some.end(), [&](const auto& found) { return knows_lanes_ && !found.binds; });
    const std::span<PathFound> in_lanes(some.begin(), others);
    fit_in_lanes(problem_, in_lanes, fit_);
    const bool half = problem_.timing == Timing::mixed && !deepening;
    place_in_order(half ? in_lanes.first(in_lanes.size() / 2) : in_lanes);
    fit_one_by_one({others, some.end()}, part);
    count_work(some, problem_.points.size(), work_);
    if (problem_.constraints.full_turn) mark_strays(some);
  }

  void place_in_order(std::span<PathFound> some) const {
    if (!assigns_places(problem_)) return;
    parallel_for(static_cast<int>(some.size()), fit_.threads,
                 [&](int index, int) { problems::place_in_order(problem_, some[index]); });
  }

  void mark_strays(std::span<PathFound> some) const {
    parallel_for(static_cast<int>(some.size()), fit_.threads, [&](int index, int) {
      PathFound& found = some[index];
      if (!found.valid) return;
      const PathModel model = model_of(problem_, found.minimum);
      const auto& x = found.minimum.solution.x;
      found.strays = deviation_.strays(model.linkage(x), model.crank_angles(x));
    });
  }

  /// By the solver that refines them later, under all limits.
  void fit_one_by_one(std::span<PathFound> some, synthesis::Shares part) {
    const auto fit_one = [&](std::size_t i) {
      PathFound& found = some[i];
      if (!found.valid) return;
      if (!found.fitted) {
        const bool binds = found.binds;
        problems::place_in_order(problem_, found);
        found.binds = found.binds || binds;
      }
      found.fitted = true;
      Solution& solution = found.minimum.solution;
      solution = minimise(
          problem_, found, synthesis::Solver::gauss_newton,
          synthesis::until(deadline_, {.tolerance = fit_.tolerance,
                                       .feasibility = kPathFeasibility,
                                       .max_iterations = found.binds ? kOrderedIterations
                                                                     : fit_.most_iterations}));
      const double missing = fit_.penalty * solution.violation;
      found.cost = solution.objective + missing * missing;
      found.valid = solution.stop != synthesis::Stop::no_value;
    };
    search_.for_each(some.size(), fit_one, part);
    for (PathFound& found : some) found.valid = found.valid && found.fitted;  // not if time is up
  }

  /// Whether the points are met by as many designs as are kept.
  bool is_met() const {
    const auto& all = search_.all();
    return !all.empty() && all.size() >= exploration_.kept && all.back().cost < kMetExactly;
  }

  const PathProblem& problem_;
  PathStarts source_;
  DeviationBetweenSamples deviation_;
  const PathExploration& exploration_;
  const Deadline& deadline_;
  Work& work_;
  /// The lanes know no loss and no limits over the turn. What they would find without those has
  /// been seen to hide better minima within them.
  const bool knows_lanes_ = problem_.solve.loss == synthesis::Loss::none &&
                            !limits_turn(problem_.constraints) &&
                            !(problem_.timing == Timing::prescribed && limits_way(problem_));
  const bool is_limited_ = is_limited(problem_);
  /// Whether points that are not timed are placed, and the transmission angle is limited over the
  /// part of the motion that is used.
  const bool places_ = assigns_places(problem_), limits_part_ = limits_way(problem_);
  synthesis::PathFitOptions fit_;
  synthesis::MultiStart<PathRules> search_;
};

}  // namespace

ExploredPaths explore_paths(const PathProblem& scaled, const PathExploration& exploration,
                            const Deadline& deadline, Work& work) {
  return Explorer(scaled, exploration, deadline, work).take();
}

}  // namespace cognate::problems
