#include "problems/function/search.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "problems/function/found.hpp"
#include "problems/search/solver_origin.hpp"

namespace cognate::problems {
namespace {

using synthesis::Objective;
using synthesis::Solver;

/// Iterations for the best minima, for those that turn minimax, and for another solver that
/// finishes.
constexpr int kDeepeningIterations = 2000;
constexpr int kTurningIterations = 150;
constexpr int kMinimaxIterations = 300;
constexpr int kFinishingIterations = 500;
/// How many of the best go on, beyond twice the designs wanted.
constexpr std::size_t kDeepened = 16;
constexpr std::size_t kFinished = 4;
/// How many least-squares designs are turned into minimax ones, which are dearer to refine.
constexpr std::size_t kMinimaxReserve = 64;
/// Starts of a round that are refined minimax, and how many must have reached the best to end it.
constexpr int kTurnedRound = 32, kEnoughBestHits = 5;
/// Rounds in which peaks between the samples join them.
constexpr int kExchangeRounds = 5;
/// Generators closer than this in the logarithms of lengths and in angles are one minimum.
constexpr double kSameMinimum = 1e-5;

/// The stages behind the exploration.
class Search {
 public:
  Search(const FunctionProblem& problem, const FunctionSamples& wanted, const Run& run,
         const Deadline& deadline, Work& work)
      : confined_(problem),
        wanted_(wanted),
        run_(run),
        deadline_(deadline),
        refiner_(confined_, run, deadline),
        solver_(finisher_of(problem)),
        work_(work),
        search_({}, {run.threads, deadline, run.progress}) {}

  FunctionSearchResult take();

 private:
  /// `reserve` and twice the designs wanted.
  std::size_t kept(std::size_t reserve) const {
    return reserve + 2 * static_cast<std::size_t>(confined_.plain().solve.designs);
  }
  void keep_best(std::size_t reserve) {
    search_.merge(kSameMinimum);
    search_.keep(kept(reserve));
  }
  void refine_all(Objective objective, Solver solver, int iterations, synthesis::Shares shares) {
    search_.refine(shares, [&](FunctionFound& found) {
      refiner_.refine(found, wanted_, objective, solver, iterations);
    });
  }
  void finish_least_squares();
  void turn_minimax(const std::vector<FunctionFound>& starts, SearchStatistics& statistics);
  void add_turned(std::vector<FunctionFound> round);
  void finish_minimax();
  void finish_by_choice(Objective objective);
  void reassess(FunctionFound& found, Objective objective) const;
  void exchange(FunctionFound& found) const;

  ConfinedFunctions confined_;
  const FunctionSamples& wanted_;
  const Run& run_;
  const Deadline& deadline_;
  FunctionRefiner refiner_;
  Solver solver_;
  Work& work_;
  synthesis::MultiStart<FunctionRules> search_;
};

/// Puts the objective and the violated limits in place of what was known of another objective.
void Search::reassess(FunctionFound& found, Objective objective) const {
  const FunctionModel model(*found.problem, wanted_, found.generator.assembly, objective);
  const std::vector<double> x = model.variables_of(found.generator);
  std::vector<double> residuals(model.residual_count()), limits(model.constraint_count());
  found.generator = model.generator(x);
  found.valid = model.residuals(x, residuals, {}, {});
  if (!found.valid) return;
  found.objective =
      objective == Objective::sum_of_squares
          ? std::inner_product(residuals.begin(), residuals.end(), residuals.begin(), 0.0)
          : std::abs(*std::ranges::max_element(residuals, {},
                                               [](double residual) { return std::abs(residual); }));
  model.constraints(x, limits, {});
  found.violation = 0;
  for (const double c : limits) found.violation = std::max(found.violation, -c);
}

/// Remez's exchange: the peaks of the error between the samples join them and the design is refined
/// again, until the largest error at the samples is the largest over the domain.
void Search::exchange(FunctionFound& found) const {
  FunctionSamples denser = wanted_;
  FunctionFound next = found;
  double largest = StructuralError(found.generator).over(wanted_).max;
  for (int round = 0; round < kExchangeRounds && !deadline_.reached(); ++round) {
    const StructuralError error(next.generator);
    const std::size_t before = denser.samples.size();
    for (const auto& peak : error.peaks(wanted_)) {
      const bool higher = std::abs(error.at(peak).value_or(0)) > next.objective * (1 + 1e-7);
      if (higher) denser.samples.push_back(peak);
    }
    if (denser.samples.size() == before) return;
    next.valid = false;  // its objective was over fewer samples
    refiner_.refine(next, denser, Objective::max_abs, Solver::gauss_newton, kFinishingIterations);
    if (solver_ != Solver::gauss_newton) {
      refiner_.refine(next, denser, Objective::max_abs, solver_, kFinishingIterations);
    }
    if (!next.valid) return;
    const double reached = StructuralError(next.generator).over(wanted_).max;
    const double violation = std::max(found.violation, kFunctionFeasibility);
    if (!(reached < largest) || next.violation > violation) continue;
    largest = reached;
    found = next;
  }
}

void Search::finish_by_choice(Objective objective) {
  if (solver_ == Solver::gauss_newton) return;
  keep_best(kFinished);
  refine_all(objective, solver_, kFinishingIterations, {0.9, 1});
}

void Search::finish_least_squares() {
  keep_best(kDeepened);
  if (confined_.plain().solve.loss == synthesis::Loss::none) {
    for (FunctionFound& found : search_.all()) reassess(found, Objective::sum_of_squares);
  }
  refine_all(Objective::sum_of_squares, Solver::gauss_newton, kDeepeningIterations, {0.7, 0.9});
  finish_by_choice(Objective::sum_of_squares);
}

void Search::add_turned(std::vector<FunctionFound> round) {
  search_.for_each(round.size(), [&](std::size_t i) {
    reassess(round[i], Objective::max_abs);
    refiner_.refine(round[i], wanted_, Objective::max_abs, Solver::gauss_newton,
                    kTurningIterations);
  });
  search_.add(std::move(round), kSameMinimum);
  search_.keep(kept(kMinimaxReserve));
}

/// Least squares draws starts away from what is best in the other sense: beside its minima the
/// starts themselves are refined, in rounds, until enough of them have reached the best.
void Search::turn_minimax(const std::vector<FunctionFound>& starts, SearchStatistics& statistics) {
  keep_best(kMinimaxReserve);
  auto& all = search_.all();
  for (FunctionFound& found : all) found.hits = 0;  // of another objective
  add_turned(std::exchange(all, {}));
  const synthesis::StartRule rule{.round = kTurnedRound,
                                  .fewest = 0,
                                  .most = static_cast<int>(starts.size()),
                                  .enough_hits = kEnoughBestHits};
  const auto add_round = [&](int first, int count) {
    const auto begin = starts.begin() + first;
    add_turned({begin, begin + count});
  };
  search_.explore(rule, {0.5, 0.7}, add_round, [&] {
    return search_.best_is_known(rule) && all.front().violation <= kFunctionFeasibility;
  });
  if (search_.starts() == 0 || all.empty()) return;
  statistics = search_.statistics(synthesis::kBestMinima);
}

void Search::finish_minimax() {
  keep_best(kFinished);
  refine_all(Objective::max_abs, Solver::gauss_newton, kMinimaxIterations, {0.7, 0.9});
  finish_by_choice(Objective::max_abs);
  if (!wanted_.at) return;
  search_.refine({1, 1}, [&](FunctionFound& found) { exchange(found); });
}

FunctionSearchResult Search::take() {
  FunctionSearchResult result;
  const bool minimax = confined_.plain().objective == FunctionObjective::minimax;
  auto explored = explore_functions(refiner_, wanted_, kept(minimax ? kMinimaxReserve : kDeepened),
                                    run_, deadline_, work_);
  result.statistics = explored.statistics;
  search_.all() = std::move(explored.minima);
  if (minimax) {
    turn_minimax(explored.starts, result.statistics);
    finish_minimax();
  } else {
    finish_least_squares();
  }
  keep_best(kDeepened);
  for (const FunctionFound& found : search_.all()) {
    result.minima.push_back({found.generator, found.origin});
  }
  const synthesis::SolverWork solved = refiner_.solved().total();
  work_.positions += solved.evaluations;
  work_.gradients += solved.gradients;
  work_.solver_iterations += solved.iterations;
  return result;
}

}  // namespace

Solver finisher_of(const FunctionProblem& problem) {
  const bool minimax = problem.objective == FunctionObjective::minimax;
  return chosen(problem.solve.solver, minimax ? Solver::slsqp : Solver::gauss_newton);
}

FunctionSearchResult search_functions(const FunctionProblem& problem, const FunctionSamples& wanted,
                                      const Run& run, const Deadline& deadline, Work& work) {
  return Search(problem, wanted, run, deadline, work).take();
}

}  // namespace cognate::problems
