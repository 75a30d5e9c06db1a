#include "problems/function/found.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "analysis/numbers/parallel.hpp"
#include "problems/search/backend_choice.hpp"

namespace cognate::problems {
namespace {

constexpr double kDefaultTolerance = 1e-13;
/// Relative difference of objectives that says nothing of two minima not yet refined to the end.
constexpr double kSameObjective = 0.01;

bool is_same(const FunctionGenerator& a, const FunctionGenerator& b, double tolerance) {
  const auto near = [&](double x, double y) { return std::abs(std::log(x / y)) < tolerance; };
  return a.assembly == b.assembly && near(a.links.crank, b.links.crank) &&
         near(a.links.coupler, b.links.coupler) && near(a.links.rocker, b.links.rocker) &&
         near(a.links.frame, b.links.frame) &&
         std::abs(wrapped(a.input_start - b.input_start)) < tolerance &&
         std::abs(wrapped(a.output_start - b.output_start)) < tolerance;
}

}  // namespace

ConfinedFunctions::ConfinedFunctions(const FunctionProblem& problem)
    : plain_(problem), crank_rocker_(problem), double_crank_(problem) {
  crank_rocker_.constraints.required_class = RequiredClass::crank_rocker;
  double_crank_.constraints.required_class = RequiredClass::double_crank;
}

const FunctionProblem& ConfinedFunctions::of(const Lengths<double>& links) const {
  const auto confined_to = confining_class(plain_.constraints, links);
  if (confined_to == plain_.constraints.required_class) return plain_;
  return confined_to == RequiredClass::crank_rocker ? crank_rocker_ : double_crank_;
}

bool is_better(const FunctionFound& a, const FunctionFound& b) {
  const bool a_feasible = a.violation <= kFunctionFeasibility;
  const bool b_feasible = b.violation <= kFunctionFeasibility;
  if (a_feasible != b_feasible) return a_feasible;
  return a_feasible ? a.objective < b.objective : a.violation < b.violation;
}

void sort_and_merge(std::vector<FunctionFound>& all, double tolerance) {
  std::erase_if(all, [](const FunctionFound& found) { return !found.valid; });
  std::ranges::stable_sort(all, is_better);
  std::vector<FunctionFound> kept;
  for (const FunctionFound& found : all) {
    const auto known = std::ranges::find_if(kept, [&](const FunctionFound& other) {
      return other.problem == found.problem && is_same(other.generator, found.generator, tolerance);
    });
    if (known == kept.end()) {
      kept.push_back(found);
      continue;
    }
    known->hits += found.hits;
    if (known->origin == StartOrigin::search)
      known->origin = found.origin;  // exact leads there too
  }
  all = std::move(kept);
}

std::ptrdiff_t groups_seen_once(const std::vector<FunctionFound>& sorted) {
  std::ptrdiff_t once = 0;
  for (std::size_t i = 0; i < sorted.size() && sorted[i].violation <= kFunctionFeasibility;) {
    const double most = sorted[i].objective * (1 + kSameObjective);
    int hits = 0;
    for (; i < sorted.size() && sorted[i].violation <= kFunctionFeasibility &&
           sorted[i].objective <= most;
         ++i) {
      hits += sorted[i].hits;
    }
    once += hits == 1;
  }
  return once;
}

bool FunctionRefiner::confine(FunctionFound& found) const {
  if (found.problem != &confined_.plain()) return false;
  found.problem = &confined_.of(found.generator.links);
  if (found.problem == &confined_.plain()) return false;
  found.valid = false;
  return true;
}

void FunctionRefiner::refine(FunctionFound& found, const FunctionSamples& wanted,
                             synthesis::Objective objective, synthesis::Backend backend,
                             int iterations) const {
  confine(found);
  refine_once(found, wanted, objective, backend, iterations);
  if (confine(found)) refine_once(found, wanted, objective, backend, iterations);
}

void FunctionRefiner::refine_once(FunctionFound& found, const FunctionSamples& wanted,
                                  synthesis::Objective objective, synthesis::Backend backend,
                                  int iterations) const {
  const Solve& asked = confined_.plain().solve;
  const FunctionModel model(
      *found.problem, wanted, found.generator.assembly, objective,
      backend == synthesis::Backend::ceres ? Closing::unguarded : Closing::guarded);
  if (!synthesis::can_solve(backend, model)) return;
  const synthesis::Solution solution = solve_by_loss(
      backend, model, asked.loss, asked.loss_scale, 1, model.variables_of(found.generator),
      {.tolerance = asked.tolerance.value_or(kDefaultTolerance),
       .max_iterations = iterations,
       .time_limit = deadline_.remaining(),
       .interrupted = deadline_.flag(),
       .seed = run_.seed});
  found.evaluations += solution.evaluations;
  found.gradients += solution.gradients;
  found.iterations += static_cast<std::uint64_t>(solution.iterations);
  if (solution.stop == synthesis::Stop::no_value) return;
  FunctionFound next = found;
  next.generator = model.generator(solution.x);
  next.objective = solution.objective;
  next.violation = solution.violation;
  next.valid = true;
  if (!found.valid || !is_better(found, next)) found = next;
}

void FunctionRefiner::refine_all(std::vector<FunctionFound>& all, const FunctionSamples& wanted,
                                 synthesis::Objective objective, synthesis::Backend backend,
                                 int iterations, Range shares) const {
  const double step = (shares.max - shares.min) / std::max<double>(1, double(all.size()));
  double best = std::numeric_limits<double>::infinity();  // of the thread that reports
  parallel_for(static_cast<int>(all.size()), run_.threads, [&](int i, int thread) {
    if (deadline_.reached()) return;
    refine(all[i], wanted, objective, backend, iterations);
    if (thread != 0 || !run_.progress) return;
    if (all[i].valid) best = std::min(best, all[i].objective);
    run_.progress(shares.min + step * i, best);
  });
}

void count_work(std::vector<FunctionFound>& all, std::size_t samples, Work& work) {
  for (FunctionFound& found : all) {
    work.positions += std::exchange(found.evaluations, 0) * samples;
    work.gradients += std::exchange(found.gradients, 0) * samples;
    work.solver_iterations += std::exchange(found.iterations, 0);
  }
}

}  // namespace cognate::problems
