#include "problems/chain/search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <list>
#include <numeric>
#include <optional>

#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "analysis/numbers/parallel.hpp"
#include "analysis/numbers/random.hpp"
#include "problems/chain/between_targets.hpp"
#include "problems/chain/chosen_targets.hpp"
#include "problems/chain/refine.hpp"
#include "problems/chain/starts/alignment.hpp"
#include "problems/chain/starts/draw.hpp"
#include "problems/chain/starts/heading.hpp"
#include "synthesis/chain/chain_fit.hpp"

namespace cognate::problems {
namespace {

using synthesis::ChainFitState;

constexpr int kRound = 256;      ///< starts between two looks at what was found
constexpr int kTrialRounds = 2;  ///< after which topologies are compared
constexpr double kBehind = 3;    ///< a topology whose error is so many times the best's is left
constexpr int kDraws = 16;       ///< chains drawn for each start, of which the nearest is taken
constexpr std::size_t kMostFitted = 64;  ///< targets that the search looks at
constexpr int kTurnChecks = 36;  ///< positions at which the search looks at transmission angles
/// By so much a cosine that goes up and down once in a turn is greater between these: (2π/36)²/8.
constexpr double kBetweenChecks = 0.004;
constexpr std::size_t kKept = 40;      ///< minima kept while searching
constexpr std::size_t kRefined = 12;   ///< of which so many are refined
constexpr int kFinalIterations = 600;  ///< of their fits
constexpr double kFinalTolerance = 1e-12;
constexpr double kHopShare = 0.6;  ///< of the starts that disturb a design known
constexpr double kMetCost = kMetError * kMetError;
constexpr double kEnough = 1e-11;    ///< and that no workshop can measure
constexpr double kNearlyMet = 1e-8;  ///< from here on the best is refined at once
constexpr double kSameChain = 1e-3;  ///< of parameters: designs closer than this are one
constexpr double kOneValley = 0.25;  ///< closer than this they are in one valley, of which
constexpr int kMostOfValley = 3;     ///< so many are kept

struct ChainRules {
  using Candidate = struct Kept {
    ChainFitState state;
    int hits = 1;
  };

  bool has_value(const Candidate& one) const { return std::isfinite(one.state.cost); }
  bool precedes(const Candidate& a, const Candidate& b) const {
    return a.state.cost < b.state.cost;
  }
  double value(const Candidate& one) const { return one.state.cost; }
  bool is_same(const Candidate& known, const Candidate& other, double tolerance) const {
    if (known.state.design.side != other.state.design.side) return false;
    const auto& a = known.state.design.parameters;
    const auto& b = other.state.design.parameters;
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (std::abs(a[i] - b[i]) > tolerance * std::max(1.0, std::abs(a[i]))) return false;
    }
    return true;
  }

  /// The best `most`, but few of one valley, so that others are searched too.
  void keep(std::vector<Candidate>& sorted, std::size_t most) const {
    std::vector<Candidate> kept;
    for (Candidate& one : sorted) {
      if (kept.size() == most) break;
      const auto near = std::ranges::count_if(
          kept, [&](const Candidate& known) { return is_same(known, one, kOneValley); });
      if (near < kMostOfValley) kept.push_back(std::move(one));
    }
    sorted = std::move(kept);
  }
};

using Candidate = ChainRules::Candidate;

/// What is fitted, of a target with many points of some alone.
struct FitTargets : ChosenTargets {
  synthesis::ChainFit fit;

  explicit FitTargets(const ScaledChain& problem) : ChosenTargets(problem, kMostFitted) {
    fit.chain = problem.chain;
    fit.trace = problem.topology->trace;
    fit.closed = problem.closed;
    for (const std::size_t chosen : which) {
      fit.x.push_back(problem.points[chosen].x);
      fit.y.push_back(problem.points[chosen].y);
      fit.root_weight.push_back(1 / std::sqrt(double(which.size())));
      if (problem.timed()) fit.crank_angles.push_back(problem.crank_angles[chosen]);
    }
    if (problem.is_motion()) take_headings(problem.headings);
    fit.free = problem.free;
    for (const int parameter : problem.free) {
      fit.lower.push_back(problem.lower[static_cast<std::size_t>(parameter)]);
      fit.upper.push_back(problem.upper[static_cast<std::size_t>(parameter)]);
    }
    fit.joints = problem.joints;
    fit.checks = problem.over_turn ? kTurnChecks : 0;
    fit.cosine_limit = problem.cosine_limit - (problem.over_turn ? kBetweenChecks : 0);
  }

 private:
  void take_headings(const WantedHeadings& wanted) {
    fit.heading = wanted.line;
    fit.angle_weight = wanted.weight;
    for (const std::size_t chosen : which) {
      fit.heading_x.push_back(wanted.directions[chosen].x);
      fit.heading_y.push_back(wanted.directions[chosen].y);
    }
  }
};

/// The search of one topology.
class ChainExplorer {
 public:
  ChainExplorer(const ScaledChain& problem, std::size_t number, const Run& run,
                const Deadline& deadline)
      : problem_(problem),
        number_(number),
        run_(run),
        targets_(problem),
        alignment_(problem),
        search_({}, {run.threads, deadline, run.progress}) {
    for (const std::size_t chosen : targets_.which)
      fitted_points_.push_back(problem.points[chosen]);
  }

  /// Fits the designs of its topology and adds them.
  void begin_with(const std::vector<ChainMinimum>& known) {
    std::vector<ChainFitState> states;
    for (const ChainMinimum& one : known) {
      if (one.problem == &problem_)
        states.push_back({one.design, targets_.chosen(problem_, one.angles)});
    }
    fit_and_add(std::move(states));
  }

  void explore(const synthesis::StartRule& rule, synthesis::Shares shares) {
    search_.explore(rule, shares, [&](int first, int count) { round(first, count); });
  }

  double best() const {
    return search_.all().empty() ? std::numeric_limits<double>::infinity()
                                 : search_.all().front().state.cost;
  }
  const synthesis::MultiStart<ChainRules>& search() const { return search_; }
  const ScaledChain& problem() const { return problem_; }
  std::uint64_t drawn() const { return drawn_; }

  /// The best designs, with angles at all targets. Their fits are brought to an end: a refinement
  /// moves each angle of the crank half of the way to its neighbours at most.
  std::vector<ChainMinimum> found() const {
    std::vector<ChainFitState> best;
    for (const Candidate& one : search_.all()) {
      if (best.size() < kRefined) best.push_back(one.state);
    }
    fit(best, {.most_iterations = kFinalIterations, .tolerance = kFinalTolerance});
    std::vector<ChainMinimum> all;
    for (std::size_t i = 0; i < best.size(); ++i) {
      const ChainFitState& state = best[i].cost >= 0 ? best[i] : search_.all()[i].state;
      all.push_back({&problem_, state.design, targets_.at_all(problem_, state.angles),
                     std::sqrt(state.cost), 0});
    }
    return all;
  }

 private:
  std::mt19937_64 random_of(int start) const {
    std::seed_seq seed{run_.seed, std::uint64_t{number_}, static_cast<std::uint64_t>(start)};
    return std::mt19937_64(seed);
  }

  void round(int first, int count) {
    std::vector<ChainFitState> states(static_cast<std::size_t>(count));
    search_.for_each(states.size(), [&](std::size_t i) {
      auto random = random_of(first + static_cast<int>(i));
      const bool hop = !search_.all().empty() && uniform(random, 0, 1) < kHopShare;
      states[i] = hop ? disturbed(random) : nearest_drawn(random);
    });
    drawn_ += states.size() * kDraws;
    std::erase_if(states, [](const ChainFitState& state) { return state.angles.empty(); });
    fit_and_add(std::move(states));
    if (best() < kNearlyMet && best() > kMetCost) refine_best();
  }

  void fit_and_add(std::vector<ChainFitState> states) {
    fit(states, screening());
    search_.for_each(states.size(), [&](std::size_t i) { note_stray(states[i]); });
    std::vector<Candidate> fresh;
    for (ChainFitState& state : states) fresh.push_back({std::move(state)});
    search_.add(std::move(fresh), kSameChain);
    search_.keep(kKept);
  }

  /// Of both ways, from the targets to the curve and back, the worse counts; of a state that is
  /// worse than those kept either way need not be known.
  void note_stray(ChainFitState& state) const {
    const bool is_full = search_.all().size() == kKept;
    const double worst = is_full ? search_.all().back().state.cost : kInfinity;
    if (!(state.cost < worst)) return;
    state.cost =
        std::max(state.cost, squared_stray(problem_, state.design, fitted_points_, state.angles));
  }

  /// An exact design is known as such by its refinement alone.
  void refine_best() {
    Candidate refined = search_.all().front();
    const RefinedChain to =
        refine(problem_, refined.state.design, targets_.at_all(problem_, refined.state.angles),
               synthesis::Solver::gauss_newton, {});
    if (to.violation > 0 || !(to.objective <= kMetCost)) return;
    refined.state.design = to.design;
    refined.state.cost = to.objective;
    search_.add({std::move(refined)}, 0);
  }

  /// Gives up starts that stay far behind the best known.
  synthesis::ChainFitOptions screening() const {
    const double known = std::min(best(), 1.0);
    synthesis::ChainFitOptions options;
    options.early_cost = std::max(0.05 * 0.05, 100 * known);
    options.late_cost = std::max(0.015 * 0.015, 6.25 * known);
    return options;
  }

  void fit(std::vector<ChainFitState>& states, synthesis::ChainFitOptions options) const {
    options.threads = run_.threads;
    options.stop = [&] { return search_.is_over(); };
    synthesis::fit_chains(targets_.fit, states, options);
  }

  /// The nearest of some chains drawn, placed on the target.
  ChainFitState nearest_drawn(std::mt19937_64& random) const {
    double nearest = std::numeric_limits<double>::infinity();
    ChainFitState best;
    for (int i = 0; i < kDraws; ++i) {
      const auto drawn = draw(problem_, random);
      if (!drawn) continue;
      const Alignment alignment = alignment_.align(drawn->curve);
      if (!(alignment.error < nearest)) continue;
      ChainFitState start{aligned(problem_, *drawn, alignment), fitted_angles(alignment)};
      const double error = std::hypot(alignment.error, turn_to_poses(start));
      if (!(error < nearest)) continue;
      nearest = error;
      best = std::move(start);
    }
    return best;
  }

  /// Of a motion, turns the body in its link; the distance that its angles then miss, root mean
  /// square.
  double turn_to_poses(ChainFitState& start) const {
    if (!problem_.is_motion()) return 0;
    std::vector<double> cranks = start.angles;
    if (problem_.timed()) {
      cranks = targets_.fit.crank_angles;
      for (double& crank : cranks) crank += start.angles.front();
    }
    return std::sqrt(turn_body(problem_, targets_.which, cranks, start.design));
  }

  std::vector<double> fitted_angles(const Alignment& alignment) const {
    const double turned = problem_.is_anchored() ? 0 : angle_of(alignment.turn);
    std::vector<double> angles;
    if (problem_.timed()) return {alignment.angles[0] + turned};
    for (const std::size_t chosen : targets_.which) {
      angles.push_back(alignment.angles[chosen] + turned);
    }
    return angles;
  }

  /// A design known with its dimensions disturbed, half of the time those of one line alone, a
  /// tenth of the time with one dyad assembled the other way.
  ChainFitState disturbed(std::mt19937_64& random) const {
    const auto& all = search_.all();
    const auto which = static_cast<std::size_t>(uniform(random, 0, double(all.size())));
    ChainFitState state = all[which].state;
    const double size = std::exp(uniform(random, std::log(0.003), std::log(0.4)));
    const bool one_line = uniform(random, 0, 1) < 0.5;
    const auto line = static_cast<std::size_t>(uniform(random, 0, double(problem_.lines.size())));
    for (std::size_t k = 0; k < problem_.lines.size(); ++k) {
      const auto& [own, parameter] = problem_.lines[k];
      if ((one_line && k != line) || !has_dimensions(own.type)) continue;
      for (int i = 0; i < synthesis::parameter_count(own.type); ++i) {
        const int place = parameter + i;
        const auto at = static_cast<std::size_t>(place);
        double& value = state.design.parameters[at];
        const double by = size * uniform(random, -1, 1) * std::max(0.3, std::abs(value));
        if (!problem_.given[at]) value += by;
      }
    }
    const auto joint = static_cast<std::size_t>(
        problem_
            .joints[static_cast<std::size_t>(uniform(random, 0, double(problem_.joints.size())))]);
    const bool free_side = !problem_.topology->lines[joint].assembly;
    if (uniform(random, 0, 1) < 0.1 && free_side) state.design.side[joint] *= -1;
    return state;
  }

  const ScaledChain& problem_;
  std::size_t number_;
  const Run& run_;
  FitTargets targets_;
  std::vector<Vec2d> fitted_points_;
  AlignmentTarget alignment_;
  synthesis::MultiStart<ChainRules> search_;
  std::uint64_t drawn_ = 0;
};

synthesis::StartRule rule_of(const Solve& options) {
  synthesis::StartRule rule;
  rule.starts = options.starts;
  rule.round = kRound;
  rule.fewest = 20 * kRound;
  rule.most = 48 * kRound;
  rule.enough_hits = 1;
  rule.patience = 3;
  rule.better_by = 0.02;
  rule.met = kEnough;
  rule.enough = kMetCost;
  return rule;
}

void refine_all(std::vector<ChainMinimum>& designs, const Solve& options, const Run& run,
                const Deadline& deadline, Work& work) {
  std::vector<RefinedChain> refined(designs.size());
  synthesis::Options own;
  own.tolerance = options.tolerance.value_or(1e-13);
  own = synthesis::until(deadline, own);
  parallel_for(static_cast<int>(designs.size()), run.threads, [&](int index, int) {
    const auto i = static_cast<std::size_t>(index);
    if (deadline.reached()) return;
    const ChainMinimum& from = designs[i];
    refined[i] =
        refine(*from.problem, from.design, from.angles, synthesis::chosen(options.solver), own);
  });
  for (std::size_t i = 0; i < designs.size(); ++i) {
    const RefinedChain& to = refined[i];
    if (to.angles.empty() || !std::isfinite(to.objective)) continue;
    work.positions += to.evaluations * designs[i].problem->points.size();
    work.gradients += to.gradients;
    work.solver_iterations += static_cast<std::uint64_t>(to.iterations);
    designs[i].design = to.design;
    designs[i].angles = to.angles;
    const ScaledChain& problem = *designs[i].problem;
    designs[i].rms = std::sqrt(to.objective);
    designs[i].stray = std::sqrt(squared_stray(problem, to.design, problem.points, to.angles));
  }
}

}  // namespace

ChainSearchResult search_chains(const std::vector<ScaledChain>& problems, const Solve& options,
                                const Run& run, const Deadline& deadline, Work& work,
                                const std::vector<ChainMinimum>& known) {
  std::list<ChainExplorer> explorers;
  for (const ScaledChain& problem : problems) {
    explorers.emplace_back(problem, explorers.size(), run, deadline).begin_with(known);
  }
  const synthesis::StartRule rule = rule_of(options);
  if (problems.size() > 1 && !options.starts) {
    synthesis::StartRule trial = rule;
    trial.starts = kTrialRounds * kRound;
    double best = std::numeric_limits<double>::infinity();
    for (ChainExplorer& one : explorers) {
      one.explore(trial, {0, 0.2});
      best = std::min(best, one.best());
    }
    const double behind = std::max(kBehind * kBehind * best, kMetCost);
    std::erase_if(explorers, [&](const ChainExplorer& one) { return one.best() > behind; });
  }
  ChainSearchResult result;
  double share = 0.2;
  const double step = 0.7 / double(std::max<std::size_t>(1, explorers.size()));
  for (ChainExplorer& one : explorers) {
    one.explore(rule, {share, share + step});
    share += step;
    work.candidates += one.drawn();
    std::ranges::move(one.found(), std::back_inserter(result.designs));
  }
  refine_all(result.designs, options, run, deadline, work);
  std::ranges::stable_sort(result.designs, {}, &ChainMinimum::rank);
  for (const ChainExplorer& one : explorers) {
    if (result.designs.empty() || &one.problem() != result.designs.front().problem) continue;
    result.statistics = one.search().statistics(synthesis::kBestMinima);
  }
  return result;
}

}  // namespace cognate::problems
