#include "problems/chain_function/search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "problems/chain/cosine_scan.hpp"
#include "problems/chain/hopping_explorer.hpp"
#include "problems/chain_function/starts.hpp"
#include "synthesis/chain/drawn.hpp"
#include "synthesis/optimise/solver.hpp"

namespace cognate::problems {
namespace {

using synthesis::Objective;

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kFeasible = 1e-7;  ///< violations up to this, of a cosine, are none
constexpr int kSearchIterations = 40, kFinalIterations = 300;
constexpr int kSearchExchanges = 2, kFinalExchanges = 8;
/// Relative, of the objective: where it is flat a design is known to the root of this alone.
constexpr double kSearchTolerance = 1e-4, kFinalTolerance = 1e-14;
constexpr int kFewestStarts = 24 * kHoppingRound;

struct FittedFunction {
  ChainFunctionDesign design;
  double error = kInfinite;
  double violation = kInfinite;
  int hits = 1;
};

struct FunctionRules {
  using Candidate = FittedFunction;

  bool has_value(const Candidate& one) const {
    return std::isfinite(one.error) && one.violation <= kFeasible;
  }
  bool precedes(const Candidate& a, const Candidate& b) const { return a.error < b.error; }
  double value(const Candidate& one) const { return one.error; }
  bool is_same(const Candidate& known, const Candidate& other, double tolerance) const {
    return is_same_chain(known.design.chain, other.design.chain, tolerance);
  }
};

/// How a fit is made.
struct Fitting {
  std::span<const synthesis::AnglePair> pairs;
  Objective objective;
  int exchanges;
  synthesis::Options options;
};

/// Fits from `start`, limits asked anew where they are extreme, until none is violated between.
FittedFunction fitted(const ChainFunctionSpace& space, const ChainFunctionDesign& start,
                      const Fitting& how, const synthesis::WorkCounter& work) {
  FittedFunction here{.design = {within_bounds(space, start.chain), start.start}};
  std::vector<TransmissionCheck> watched;
  const auto watch = [&] {
    double violation = 0;
    const auto extremes =
        CosineScan(space, here.design.chain).extremes(space.span(here.design.start), violation);
    problems::watch(space, extremes, watched);
    return violation;
  };
  watch();
  for (int exchange = 0; exchange < how.exchanges; ++exchange) {
    const ChainFunctionModel model(space, here.design, watched, how.pairs, how.objective);
    const auto solution = minimum_within(model, model.start(), how.options, kFeasible, work);
    if (solution.stop == synthesis::Stop::no_value || !std::isfinite(solution.objective)) break;
    const double before = here.design.start;
    here.design = model.design(solution.x);
    synthesis::draw_anew(space.lines, {1, 0}, here.design.chain);
    for (TransmissionCheck& check : watched) check.crank += here.design.start - before;
    here.error = how.objective == Objective::max_abs
                     ? solution.objective
                     : std::sqrt(solution.objective / double(how.pairs.size()));
    here.violation = std::max(solution.violation, watch());
    if (here.violation <= kFeasible) break;
  }
  return here;
}

/// At the fine pairs, the output's start being the best.
double largest_error(const ChainFunctionSpace& space, const ChainFunctionDesign& design) {
  const ChainFunctionModel model(space, design, {}, space.fine, Objective::max_abs);
  std::vector<double> errors(space.fine.size());
  if (!model.residuals(model.start(), errors, {}, {})) return kInfinite;
  return std::abs(
      *std::ranges::max_element(errors, {}, [](double error) { return std::abs(error); }));
}

FittedFunction better(const FittedFunction& known, const FittedFunction& other) {
  const bool is_known = known.violation <= kFeasible;
  const bool is_better = other.violation <= kFeasible && (!is_known || other.error < known.error);
  return is_better ? other : known;
}

struct FunctionMethod {
  using Space = ChainFunctionSpace;
  using Design = ChainFunctionDesign;
  using Rules = FunctionRules;
  /// Of another valley than that of the first good designs most starts would find none.
  static constexpr std::uint64_t kDrawnStarts = std::uint64_t{6} * kHoppingRound;
  static constexpr double kHopShare = 0.7;

  static std::optional<Design> draw(const Space& space, std::mt19937_64& random) {
    return draw_chain_function(space, random);
  }

  static void disturb(const Space& space, double size, Design& design, std::mt19937_64& random) {
    problems::disturb(space, size, design.chain, random);
    design.start += size * uniform(random, -1, 1);
  }

  /// By least squares, whatever is asked for.
  static FittedFunction search_fit(const Space& space, const Design& start,
                                   const synthesis::Deadline& deadline,
                                   const synthesis::WorkCounter& work) {
    const auto options = fit_options(deadline, kSearchIterations, kSearchTolerance);
    return fitted(space, start,
                  {space.coarse, Objective::sum_of_squares, kSearchExchanges, options}, work);
  }

  static FittedFunction final_fit(const Space& space, const Design& start,
                                  const synthesis::Deadline& deadline,
                                  const synthesis::WorkCounter& work) {
    Fitting how{space.fine, Objective::sum_of_squares, kFinalExchanges,
                fit_options(deadline, kFinalIterations, kFinalTolerance)};
    FittedFunction best = fitted(space, start, how, work);
    if (!space.is_minimax) return best;
    best.error = largest_error(space, best.design);
    how.objective = Objective::max_abs;
    return better(best, fitted(space, best.design, how, work));
  }
};

std::vector<ChainFunctionDesign> known_functions(const ChainFunctionSpace& space,
                                                 const std::vector<Design>& known) {
  std::vector<ChainFunctionDesign> starts;
  for (const auto& [chain, design] : known_chains(space, space.scale, known)) {
    if (design->metrics.input_start) starts.push_back({chain, *design->metrics.input_start});
  }
  return starts;
}

}  // namespace

ChainFunctionSearch search_chain_functions(const std::vector<ChainFunctionSpace>& spaces,
                                           const Solve& options, const Run& run,
                                           const Deadline& deadline, Work& work) {
  const synthesis::WorkCounter counter;
  const auto explorers = explored<HoppingExplorer<FunctionMethod>>(
      spaces, [&](const ChainFunctionSpace& space) { return known_functions(space, run.known); },
      hopping_rule(options.starts, kFewestStarts), run, deadline, counter);
  ChainFunctionSearch result;
  for (const auto& one : explorers) {
    for (const FittedFunction& found : one.search().all()) {
      result.designs.push_back({&one.space(), found.design, found.error});
    }
  }
  std::ranges::stable_sort(result.designs, {}, &ChainFunctionMinimum::error);
  result.statistics = statistics_of(explorers, result.designs);
  count_work(counter, explorers, static_cast<int>(spaces.front().coarse.size()), work);
  return result;
}

}  // namespace cognate::problems
