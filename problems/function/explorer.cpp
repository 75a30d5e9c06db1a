#include "problems/function/explorer.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <utility>

#include "analysis/linkage/mobility.hpp"
#include "analysis/numbers/parallel.hpp"

namespace cognate::problems {
namespace {

using synthesis::Backend;
using synthesis::Objective;

/// Starts of a round, and the fewest and most of a search where the file does not say.
constexpr int kRound = 64, kFewestStarts = 128, kMostStarts = 256;
/// The best minimum counts as well known once so many starts have come to it.
constexpr int kEnoughHits = 5;
constexpr int kIterations = 150;
/// Weight of violated limits among the errors.
constexpr double kPenalty = 10;
/// Fits that end closer than this in the logarithms of lengths and in angles are one.
constexpr double kSameFit = 1e-4;

class Explorer {
 public:
  Explorer(const ConfinedFunctions& confined, const FunctionSamples& wanted, std::size_t kept,
           const Run& run, const Deadline& deadline, Work& work)
      : confined_(confined),
        wanted_(wanted),
        kept_(kept),
        run_(run),
        deadline_(deadline),
        refiner_(confined, run, deadline),
        work_(work) {}

  ExploredFunctions take(SearchThoroughness& thoroughness) {
    const auto& asked = confined_.plain().solve.starts;
    const int most = asked.value_or(kMostStarts), round = asked.value_or(kRound);
    int done = 0;
    add_known();
    while (done < most && !deadline_.reached()) {
      add_round(done, round, most);
      done += round;
      const bool known = !pool_.empty() && pool_.front().hits >= kEnoughHits;
      if (done >= kFewestStarts && known) break;
    }
    const auto seen_once = std::ranges::count(pool_, 1, &FunctionFound::hits);
    thoroughness.starts = done;
    thoroughness.best_hits = pool_.empty() ? 0 : pool_.front().hits;
    thoroughness.unseen = chance_of_unseen(seen_once, done);
    return {std::move(pool_), std::move(starts_)};
  }

 private:
  bool is_minimax() const { return confined_.plain().objective == FunctionObjective::minimax; }

  void add_round(int first, int count, int most) {
    const auto starts = find_starts(confined_.plain(), wanted_,
                                    {.seed = run_.seed,
                                     .threads = thread_count(run_.threads),
                                     .first = first,
                                     .count = count,
                                     .deadline = &deadline_});
    work_.candidates += starts.candidates;
    work_.positions += starts.candidates * wanted_.samples.size();
    std::vector<FunctionFound> fresh;
    for (const FunctionStartPoint& start : starts.starts) {
      fresh.push_back(placed(start.generator, start.origin));
    }
    if (is_minimax()) std::ranges::copy(fresh, std::back_inserter(starts_));
    add(std::move(fresh), {0.5 * first / most, 0.5 * (first + count) / most});
  }

  /// Designs that the run begins with.
  void add_known() {
    std::vector<FunctionFound> fresh;
    for (const Design& design : run_.known) {
      const FourBar& linkage = four_bar(design);
      const Metrics& metrics = design.metrics;
      fresh.push_back(placed({lengths(linkage), linkage.assembly, metrics.input_start.value_or(0),
                              metrics.output_start.value_or(0)},
                             StartOrigin::search));
      fresh.back().hits = 0;  // no start of the search
    }
    if (!fresh.empty()) add(std::move(fresh), {0, 0});
  }

  FunctionFound placed(const FunctionGenerator& generator, StartOrigin origin) const {
    return {.generator = generator, .origin = origin, .problem = &confined_.of(generator.links)};
  }

  void add(std::vector<FunctionFound> fresh, Range shares) {
    fit(fresh, shares);
    count_work(fresh, wanted_.samples.size(), work_);
    std::ranges::move(fresh, std::back_inserter(pool_));
    sort_and_merge(pool_, kSameFit);
    if (pool_.size() > kept_) pool_.resize(kept_);
  }

  /// In SIMD lanes, unless start angles follow from the lengths, errors count by a loss or
  /// something is limited over the full turn. Those of one problem are fitted together.
  void fit(std::vector<FunctionFound>& all, Range shares) const {
    const FunctionProblem& problem = confined_.plain();
    const bool plain = problem.solve.loss == synthesis::Loss::none;
    const bool limited = limits_turn(problem.constraints);
    if (!plain || limited || problem.start != FunctionStart::free) {
      refiner_.refine_all(all, wanted_, Objective::sum_of_squares, Backend::gauss_newton,
                          kIterations, shares);
      return;
    }
    std::ranges::stable_sort(all, {}, &FunctionFound::problem);
    const std::vector<FunctionFound> starts = all;
    for (auto first = all.begin(); first != all.end();) {
      const auto last = std::find_if(first, all.end(), [&](const FunctionFound& found) {
        return found.problem != first->problem;
      });
      fit_in_lanes({first, last});
      first = last;
    }
    follow_border(starts, all);
  }

  void fit_in_lanes(std::span<FunctionFound> all) const {
    const FunctionFound& any = all.front();
    const FunctionModel model(*any.problem, wanted_, any.generator.assembly,
                              Objective::sum_of_squares);
    std::vector<synthesis::FunctionFitState> states;
    for (const FunctionFound& found : all) {
      const auto& [links, assembly, input_start, output_start] = found.generator;
      states.push_back({{links.crank, links.coupler, links.rocker, links.frame},
                        input_start,
                        output_start,
                        sign(assembly)});
    }
    fit_functions(model.lane_fit(), states,
                  {.most_iterations = kIterations,
                   .penalty = kPenalty,
                   .threads = run_.threads,
                   .stop = [this] { return deadline_.reached(); }});
    for (std::size_t i = 0; i < all.size(); ++i) take_over(states[i], all[i]);
  }

  static void take_over(const synthesis::FunctionFitState& state, FunctionFound& found) {
    const auto [crank, coupler, rocker, frame] = state.length;
    found.generator.links = {crank, coupler, rocker, frame};
    found.generator.input_start = state.input_start;
    found.generator.output_start = state.output_start;
    found.objective = state.cost;
    found.valid = std::isfinite(state.cost);
    found.evaluations += 2 * static_cast<std::uint64_t>(state.iterations);
    found.gradients += static_cast<std::uint64_t>(state.iterations);
    found.iterations += static_cast<std::uint64_t>(state.iterations);
  }

  /// The lanes stop at the border of what closes; constraints lead along it. They keep no start to
  /// another class than it began with: one whose crank turns fully in the end goes on in its own.
  void follow_border(const std::vector<FunctionFound>& starts,
                     std::vector<FunctionFound>& all) const {
    parallel_for(static_cast<int>(all.size()), run_.threads, [&](int i, int) {
      if (deadline_.reached() || !all[i].valid) return;
      if (refiner_.confine(all[i])) {
        refiner_.refine(all[i], wanted_, Objective::sum_of_squares, Backend::gauss_newton,
                        kIterations);
        penalise(all[i]);
        return;
      }
      if (!is_nearly_folded(all[i].generator)) return;
      FunctionFound along = starts[i];
      refiner_.refine(along, wanted_, Objective::sum_of_squares, Backend::gauss_newton,
                      kIterations);
      if (!along.valid) return;
      penalise(along);
      if (all[i].objective < along.objective) return;
      along.evaluations += all[i].evaluations;
      along.gradients += all[i].gradients;
      along.iterations += all[i].iterations;
      all[i] = along;
    });
  }

  /// Counts what is violated among the errors, as the lanes do.
  static void penalise(FunctionFound& found) {
    const double missing = kPenalty * found.violation;
    found.objective += missing * missing;
    found.violation = 0;
  }

  /// Whether coupler and rocker are within half a degree of one line at a sample.
  bool is_nearly_folded(const FunctionGenerator& generator) const {
    constexpr double kFolded = 0.99996;
    const auto& [l1, l2, l3, l4] = generator.links;
    return std::ranges::any_of(wanted_.samples, [&](const synthesis::AnglePair& pair) {
      const double across = 2 * l1 * l4 * std::cos(generator.input_start + pair.input);
      const double cosine = (l2 * l2 + l3 * l3 - l1 * l1 - l4 * l4 + across) / (2 * l2 * l3);
      return std::abs(cosine) > kFolded;
    });
  }

  const ConfinedFunctions& confined_;
  const FunctionSamples& wanted_;
  std::size_t kept_;
  const Run& run_;
  const Deadline& deadline_;
  FunctionRefiner refiner_;
  Work& work_;
  std::vector<FunctionFound> pool_, starts_;
};

}  // namespace

ExploredFunctions explore_functions(const ConfinedFunctions& confined,
                                    const FunctionSamples& wanted, std::size_t kept, const Run& run,
                                    const Deadline& deadline, Work& work,
                                    SearchThoroughness& thoroughness) {
  return Explorer(confined, wanted, kept, run, deadline, work).take(thoroughness);
}

}  // namespace cognate::problems
