#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <utility>

#include "analysis/linkage/mobility.hpp"
#include "analysis/numbers/parallel.hpp"
#include "problems/function/screen.hpp"
#include "problems/function/search.hpp"

namespace cognate::problems {
namespace {

using synthesis::Objective;
using synthesis::Solver;

/// Starts of a round, and the fewest and most of a search where the file does not say.
constexpr int kRound = 64, kFewestStarts = 128, kMostStarts = 256;
constexpr int kIterations = 150;
/// Fits that end closer than this in the logarithms of lengths and in angles are one.
constexpr double kSameFit = 1e-4;

class Explorer {
 public:
  Explorer(const FunctionRefiner& refiner, const FunctionSamples& wanted, std::size_t kept,
           const Run& run, const Deadline& deadline, Work& work)
      : refiner_(refiner),
        problem_(refiner.confined().plain()),
        wanted_(wanted),
        kept_(kept),
        run_(run),
        deadline_(deadline),
        work_(work),
        search_({}, {run.threads, deadline, run.progress}) {}

  ExploredFunctions take() {
    const auto& asked = problem_.solve.starts;
    add_known();
    search_.explore({.starts = asked,
                     .round = asked.value_or(kRound),
                     .fewest = kFewestStarts,
                     .most = kMostStarts},
                    {0, 0.5}, [&](int first, int count) { add_round(first, count); });
    const SearchStatistics statistics = search_.statistics(synthesis::kBestMinima);
    return {std::move(search_.all()), std::move(starts_), statistics};
  }

 private:
  bool is_minimax() const { return problem_.objective == FunctionObjective::minimax; }

  void add_round(int first, int count) {
    const auto starts = find_starts(problem_, wanted_,
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
    add(std::move(fresh));
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
    if (!fresh.empty()) add(std::move(fresh));
  }

  FunctionFound placed(const FunctionGenerator& generator, StartOrigin origin) const {
    return {.generator = generator,
            .origin = origin,
            .problem = &refiner_.confined().of(generator.links)};
  }

  void add(std::vector<FunctionFound> fresh) {
    fit(fresh);
    search_.add(std::move(fresh), kSameFit);
    search_.keep(kept_);
  }

  /// In SIMD lanes, unless start angles follow from the lengths, errors count by a loss or
  /// something is limited over the full turn. Those of one problem are fitted together.
  void fit(std::vector<FunctionFound>& all) const {
    const bool plain = problem_.solve.loss == synthesis::Loss::none;
    const bool limited = limits_turn(problem_.constraints);
    if (!plain || limited || problem_.start != FunctionStart::free) {
      search_.for_each(all.size(), [&](std::size_t i) { refine(all[i]); });
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

  void refine(FunctionFound& found) const {
    refiner_.refine(found, wanted_, Objective::sum_of_squares, Solver::gauss_newton, kIterations);
  }

  void take_over(const synthesis::FunctionFitState& state, FunctionFound& found) const {
    const auto [crank, coupler, rocker, frame] = state.length;
    found.generator.links = {crank, coupler, rocker, frame};
    found.generator.input_start = state.input_start;
    found.generator.output_start = state.output_start;
    found.objective = state.cost;
    found.valid = std::isfinite(state.cost);
    const auto steps = static_cast<std::uint64_t>(state.iterations);
    refiner_.solved().count({2 * steps, steps, steps}, wanted_.samples.size());
  }

  /// The lanes stop at the border of what closes; constraints lead along it. They keep no start to
  /// another class than it began with: one whose crank turns fully in the end goes on in its own,
  /// or from its start within the class of that, whichever is better.
  void follow_border(const std::vector<FunctionFound>& starts,
                     std::vector<FunctionFound>& all) const {
    search_.for_each(all.size(), [&](std::size_t i) {
      if (!all[i].valid) return;
      if (refiner_.confine(all[i])) {
        refine(all[i]);
        penalise(all[i]);
        FunctionFound stayed = starts[i];
        refiner_.stay(stayed);
        refine(stayed);
        penalise(stayed);
        if (stayed.valid && !(all[i].valid && all[i].objective <= stayed.objective))
          all[i] = stayed;
        return;
      }
      if (!is_nearly_folded(all[i].generator)) return;
      FunctionFound along = starts[i];
      refine(along);
      if (!along.valid) return;
      penalise(along);
      if (!(all[i].objective < along.objective)) all[i] = along;
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

  const FunctionRefiner& refiner_;
  const FunctionProblem& problem_;
  const FunctionSamples& wanted_;
  std::size_t kept_;
  const Run& run_;
  const Deadline& deadline_;
  Work& work_;
  synthesis::MultiStart<FunctionRules> search_;
  std::vector<FunctionFound> starts_;
};

}  // namespace

ExploredFunctions explore_functions(const FunctionRefiner& refiner, const FunctionSamples& wanted,
                                    std::size_t kept, const Run& run, const Deadline& deadline,
                                    Work& work) {
  return Explorer(refiner, wanted, kept, run, deadline, work).take();
}

}  // namespace cognate::problems
