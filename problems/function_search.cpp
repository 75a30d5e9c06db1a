#include "problems/function_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "analysis/mobility.hpp"
#include "analysis/parallel.hpp"
#include "problems/backend_choice.hpp"
#include "problems/function_model.hpp"
#include "problems/function_starts.hpp"

namespace cognate::problems {
namespace {

using synthesis::Backend;
using synthesis::Objective;
using synthesis::Solution;

constexpr int kDefaultStarts = 256;
constexpr double kDefaultTolerance = 1e-13;
/// Iterations for every start, for the best of them, and for another solver that finishes those.
constexpr int kSearchIterations = 150;
constexpr int kDeepeningIterations = 2000;
constexpr int kMinimaxIterations = 300;
constexpr int kFinishingIterations = 500;
/// How many of the best go on, beyond twice the designs wanted.
constexpr int kDeepened = 16;
constexpr int kFinished = 4;
/// How many least-squares designs are turned into minimax ones, which are dearer to refine.
constexpr int kMinimaxReserve = 24;
/// Rounds in which peaks between the samples join them.
constexpr int kExchangeRounds = 5;
/// Generators closer than this in the logarithms of lengths and in angles are one minimum.
constexpr double kSameWithin = 1e-5;

/// A generator on its way to a minimum, and the problem it is confined to.
struct Refined {
  FunctionGenerator generator;
  StartOrigin origin = StartOrigin::search;
  const FunctionProblem* problem = nullptr;
  LimitedMotion limited = LimitedMotion::sweep;
  double objective = 0;
  double violation = 0;
  bool valid = false;
  std::uint64_t evaluations = 0, gradients = 0, iterations = 0;
};

bool better(const Refined& a, const Refined& b) {
  const double met = 1e-9;
  if ((a.violation <= met) != (b.violation <= met)) return a.violation <= met;
  return a.violation <= met ? a.objective < b.objective : a.violation < b.violation;
}

bool same(const FunctionGenerator& a, const FunctionGenerator& b) {
  const auto near = [](double x, double y) { return std::abs(std::log(x / y)) < kSameWithin; };
  return a.assembly == b.assembly && near(a.links.crank, b.links.crank) &&
         near(a.links.coupler, b.links.coupler) && near(a.links.rocker, b.links.rocker) &&
         near(a.links.frame, b.links.frame) &&
         std::abs(wrapped(a.input_start - b.input_start)) < kSameWithin &&
         std::abs(wrapped(a.output_start - b.output_start)) < kSameWithin;
}

/// The problem as it stands and with each class whose crank turns fully. Where the transmission
/// angle is limited without a class, a start with a turning crank keeps its class, because its
/// limits are then those of the full turn.
struct Confined {
  FunctionProblem plain, crank_rocker, double_crank;

  explicit Confined(const FunctionProblem& problem)
      : plain(problem), crank_rocker(problem), double_crank(problem) {
    crank_rocker.constraints.required_class = RequiredClass::crank_rocker;
    double_crank.constraints.required_class = RequiredClass::double_crank;
  }

  const FunctionProblem& of(const Lengths<double>& links) const {
    const auto& required = plain.constraints.required_class;
    const bool open = !required || *required == RequiredClass::grashof;
    if (!open || !plain.constraints.transmission_angle) return plain;
    switch (mobility_class(links)) {
      case MobilityClass::crank_rocker:
        return crank_rocker;
      case MobilityClass::double_crank:
        return double_crank;
      default:
        return plain;
    }
  }
};

class Search {
 public:
  Search(const FunctionProblem& problem, const FunctionSamples& wanted, const Run& run,
         const Deadline& deadline)
      : confined_(problem), wanted_(wanted), run_(run), deadline_(deadline) {}

  /// Local minima from all starts, best first.
  std::vector<Refined> minima(Work& work);

 private:
  Objective objective() const {
    return confined_.plain.objective == FunctionObjective::minimax ? Objective::max_abs
                                                                   : Objective::sum_of_squares;
  }

  void refine(Refined& design, const FunctionSamples& wanted, Objective objective, Backend backend,
              int iterations) const;
  void explore(std::vector<Refined>& all) const;
  void fit_in_lanes(std::span<Refined> all) const;
  void reassess(Refined& design) const;
  bool is_nearly_folded(const FunctionGenerator& generator) const;
  void exchange(Refined& design, Backend backend) const;
  void keep_best(std::vector<Refined>& all, int reserve, Work& work) const;
  void refine_all(std::vector<Refined>& all, Objective objective, Backend backend, int iterations,
                  Range shares) const;

  Confined confined_;
  const FunctionSamples& wanted_;
  const Run& run_;
  const Deadline& deadline_;
};

/// Goes on from where `design` stands; keeps the result unless it is worse by the same objective.
void Search::refine(Refined& design, const FunctionSamples& wanted, Objective objective,
                    Backend backend, int iterations) const {
  const FunctionModel model(*design.problem, wanted, design.generator.assembly, objective,
                            design.limited,
                            backend == Backend::ceres ? Closing::unguarded : Closing::guarded);
  if (!synthesis::can_solve(backend, model)) return;
  const Solve& asked = confined_.plain.solve;
  const Solution solution = solve_by_loss(
      backend, model, asked.loss, asked.loss_scale, 1, model.variables_of(design.generator),
      {.tolerance = confined_.plain.solve.tolerance.value_or(kDefaultTolerance),
       .max_iterations = iterations,
       .time_limit = deadline_.remaining(),
       .interrupted = deadline_.flag(),
       .seed = run_.seed});
  design.evaluations += solution.evaluations;
  design.gradients += solution.gradients;
  design.iterations += static_cast<std::uint64_t>(solution.iterations);
  if (solution.stop == synthesis::Stop::no_value) return;
  Refined next = design;
  next.generator = model.generator(solution.x);
  next.objective = solution.objective;
  next.violation = solution.violation;
  next.valid = true;
  if (!design.valid || !better(design, next)) design = next;
}

void Search::refine_all(std::vector<Refined>& all, Objective objective, Backend backend,
                        int iterations, Range shares) const {
  const double step = (shares.max - shares.min) / std::max<double>(1, double(all.size()));
  double best = std::numeric_limits<double>::infinity();  // of the thread that reports
  parallel_for(static_cast<int>(all.size()), run_.threads, [&](int i, int thread) {
    if (deadline_.reached()) return;
    refine(all[i], wanted_, objective, backend, iterations);
    if (thread != 0 || !run_.progress) return;
    if (all[i].valid) best = std::min(best, all[i].objective);
    run_.progress(shares.min + step * i, best);
  });
}

/// Brings all starts near their minima: in SIMD lanes, unless start angles follow from the lengths,
/// errors count by a loss or something is limited over the full turn. Those of one problem are
/// fitted together.
void Search::explore(std::vector<Refined>& all) const {
  const bool plain = confined_.plain.solve.loss == synthesis::Loss::none;
  const bool limited = limits_turn(confined_.plain.constraints);
  if (!plain || limited || confined_.plain.start != FunctionStart::free) {
    refine_all(all, Objective::sum_of_squares, Backend::gauss_newton, kSearchIterations,
               {0.1, 0.5});
    return;
  }
  const auto key = [](const Refined& design) { return std::pair(design.problem, design.limited); };
  std::ranges::stable_sort(all, {}, key);
  const std::vector<Refined> starts = all;
  for (auto first = all.begin(); first != all.end();) {
    const auto last = std::find_if(
        first, all.end(), [&](const Refined& design) { return key(design) != key(*first); });
    fit_in_lanes({first, last});
    first = last;
  }
  // The lanes stop at the border of what closes; constraints lead along it.
  parallel_for(static_cast<int>(all.size()), run_.threads, [&](int i, int) {
    if (deadline_.reached() || !(all[i].valid && is_nearly_folded(all[i].generator))) return;
    Refined along = starts[i];
    refine(along, wanted_, Objective::sum_of_squares, Backend::gauss_newton, kSearchIterations);
    if (!along.valid || better(all[i], along)) return;
    along.evaluations += all[i].evaluations;
    along.gradients += all[i].gradients;
    along.iterations += all[i].iterations;
    all[i] = along;
  });
}

/// Puts the error and the violated limits themselves in place of what a fit in lanes made of them.
void Search::reassess(Refined& design) const {
  const FunctionModel model(*design.problem, wanted_, design.generator.assembly,
                            Objective::sum_of_squares, design.limited);
  const std::vector<double> x = model.variables_of(design.generator);
  std::vector<double> residuals(model.residual_count()), limits(model.constraint_count());
  design.generator = model.generator(x);
  design.valid = model.residuals(x, residuals, {}, {});
  if (!design.valid) return;
  design.objective = std::inner_product(residuals.begin(), residuals.end(), residuals.begin(), 0.0);
  model.constraints(x, limits, {});
  design.violation = 0;
  for (const double c : limits) design.violation = std::max(design.violation, -c);
}

/// Whether coupler and rocker are within half a degree of one line at a sample.
bool Search::is_nearly_folded(const FunctionGenerator& generator) const {
  constexpr double kFolded = 0.99996;
  const auto& [l1, l2, l3, l4] = generator.links;
  return std::ranges::any_of(wanted_.samples, [&](const synthesis::AnglePair& pair) {
    const double across = 2 * l1 * l4 * std::cos(generator.input_start + pair.input);
    const double cosine = (l2 * l2 + l3 * l3 - l1 * l1 - l4 * l4 + across) / (2 * l2 * l3);
    return std::abs(cosine) > kFolded;
  });
}

void Search::fit_in_lanes(std::span<Refined> all) const {
  const Refined& any = all.front();
  const FunctionModel model(*any.problem, wanted_, any.generator.assembly,
                            Objective::sum_of_squares, any.limited);
  std::vector<synthesis::FunctionFitState> states;
  for (const Refined& design : all) {
    const auto& [links, assembly, input_start, output_start] = design.generator;
    states.push_back({{links.crank, links.coupler, links.rocker, links.frame},
                      input_start,
                      output_start,
                      sign(assembly)});
  }
  fit_functions(model.lane_fit(), states,
                {.most_iterations = kSearchIterations, .threads = run_.threads, .stop = [this] {
                   return deadline_.reached();
                 }});
  for (std::size_t i = 0; i < all.size(); ++i) {
    const synthesis::FunctionFitState& state = states[i];
    const auto [crank, coupler, rocker, frame] = state.length;
    all[i].generator.links = {crank, coupler, rocker, frame};
    all[i].generator.input_start = state.input_start;
    all[i].generator.output_start = state.output_start;
    all[i].objective = state.cost;
    all[i].valid = std::isfinite(state.cost);
    all[i].evaluations += 2 * static_cast<std::uint64_t>(state.iterations);
    all[i].gradients += static_cast<std::uint64_t>(state.iterations);
    all[i].iterations += static_cast<std::uint64_t>(state.iterations);
  }
}

/// Remez's exchange: the peaks of the error between the samples join them and the design is refined
/// again, until the largest error at the samples is the largest over the domain.
void Search::exchange(Refined& design, Backend backend) const {
  FunctionSamples denser = wanted_;
  Refined next = design;
  double largest = StructuralError(design.generator).over(wanted_).max;
  for (int round = 0; round < kExchangeRounds && !deadline_.reached(); ++round) {
    const StructuralError error(next.generator);
    const std::size_t before = denser.samples.size();
    for (const auto& peak : error.peaks(wanted_)) {
      const bool higher = std::abs(error.at(peak).value_or(0)) > next.objective * (1 + 1e-7);
      if (higher) denser.samples.push_back(peak);
    }
    if (denser.samples.size() == before) return;
    next.valid = false;  // its objective was over fewer samples
    refine(next, denser, Objective::max_abs, Backend::gauss_newton, kFinishingIterations);
    if (backend != Backend::gauss_newton) {
      refine(next, denser, Objective::max_abs, backend, kFinishingIterations);
    }
    if (!next.valid) return;
    const double reached = StructuralError(next.generator).over(wanted_).max;
    const double violation = std::max(design.violation, 1e-9);
    if (!(reached < largest) || next.violation > violation) continue;
    largest = reached;
    design = next;
  }
}

/// Counts what was done, sorts and merges equal ones; keeps `reserve` and twice the designs wanted.
void Search::keep_best(std::vector<Refined>& all, int reserve, Work& work) const {
  for (Refined& design : all) {
    work.positions += std::exchange(design.evaluations, 0) * wanted_.samples.size();
    work.gradients += std::exchange(design.gradients, 0) * wanted_.samples.size();
    work.solver_iterations += std::exchange(design.iterations, 0);
  }
  std::erase_if(all, [](const Refined& design) { return !design.valid; });
  std::ranges::stable_sort(all, better);
  const auto most = static_cast<std::size_t>(reserve) +
                    2 * static_cast<std::size_t>(confined_.plain.solve.designs);
  std::vector<Refined> kept;
  for (const Refined& design : all) {
    if (kept.size() == most) break;
    const auto known = std::ranges::find_if(
        kept, [&](const Refined& other) { return same(other.generator, design.generator); });
    if (known == kept.end()) {
      kept.push_back(design);
    } else if (known->origin == StartOrigin::search) {
      known->origin = design.origin;  // exact synthesis leads there too
    }
  }
  all = std::move(kept);
}

std::vector<Refined> Search::minima(Work& work) {
  const FunctionProblem& problem = confined_.plain;
  const auto found = find_starts(problem, wanted_,
                                 {.seed = run_.seed,
                                  .threads = thread_count(run_.threads),
                                  .count = problem.solve.starts.value_or(kDefaultStarts),
                                  .deadline = &deadline_});
  work.candidates += found.candidates;
  work.positions += found.candidates * wanted_.samples.size();
  std::vector<Refined> all;
  for (const FunctionStartPoint& start : found.starts) {
    const FunctionProblem& own = confined_.of(start.generator.links);
    const bool full_turn = crank_rotates(start.generator.links);
    all.push_back({.generator = start.generator,
                   .origin = start.origin,
                   .problem = &own,
                   .limited = full_turn ? LimitedMotion::full_turn : LimitedMotion::sweep});
  }
  explore(all);
  const bool minimax = objective() == Objective::max_abs;
  if (minimax) {
    keep_best(all, kMinimaxReserve, work);
    for (Refined& design : all) design.valid = false;  // its objective was another
    refine_all(all, objective(), Backend::gauss_newton, kSearchIterations, {0.5, 0.7});
  }
  const auto backend = finisher_of(problem);
  keep_best(all, minimax ? kFinished : kDeepened, work);
  const bool plain = problem.solve.loss == synthesis::Loss::none;
  if (!minimax && plain) std::ranges::for_each(all, [this](Refined& d) { reassess(d); });
  refine_all(all, objective(), Backend::gauss_newton,
             minimax ? kMinimaxIterations : kDeepeningIterations, {0.7, 0.9});
  if (backend != Backend::gauss_newton) {
    keep_best(all, kFinished, work);
    refine_all(all, objective(), backend, kFinishingIterations, {0.9, 1});
  }
  if (minimax && wanted_.at) {
    parallel_for(static_cast<int>(all.size()), run_.threads,
                 [&](int i, int) { exchange(all[i], backend); });
  }
  keep_best(all, kDeepened, work);
  return all;
}

}  // namespace

Backend finisher_of(const FunctionProblem& problem) {
  const bool minimax = problem.objective == FunctionObjective::minimax;
  const bool automatic = problem.solve.solver == SolverChoice::automatic;
  return automatic && minimax ? Backend::slsqp : backend_of(problem.solve.solver);
}

std::vector<FoundFunction> search_functions(const FunctionProblem& problem,
                                            const FunctionSamples& wanted, const Run& run,
                                            const Deadline& deadline, Work& work) {
  std::vector<FoundFunction> found;
  for (const Refined& minimum : Search(problem, wanted, run, deadline).minima(work)) {
    found.push_back({minimum.generator, minimum.origin});
  }
  return found;
}

}  // namespace cognate::problems
