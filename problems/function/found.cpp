#include "problems/function/found.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "problems/linkage/verify.hpp"
#include "problems/search/solver_origin.hpp"

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
    : plain_(problem),
      crank_rocker_(problem),
      double_crank_(problem),
      rocker_crank_(problem),
      double_rocker_(problem),
      triple_rocker_(problem) {
  rocker_crank_.constraints.required_class = RequiredClass::rocker_crank;
  double_rocker_.constraints.required_class = RequiredClass::double_rocker;
  triple_rocker_.constraints.required_class = RequiredClass::triple_rocker;
  crank_rocker_.constraints.required_class = RequiredClass::crank_rocker;
  double_crank_.constraints.required_class = RequiredClass::double_crank;
}

const FunctionProblem& ConfinedFunctions::of(const Lengths<double>& links) const {
  const auto confined_to = confining_class(plain_.constraints, links);
  if (confined_to == plain_.constraints.required_class) return plain_;
  return confined_to == RequiredClass::crank_rocker ? crank_rocker_ : double_crank_;
}

const FunctionProblem& ConfinedFunctions::staying(const Lengths<double>& links) const {
  switch (mobility_class(links)) {
    case MobilityClass::rocker_crank:
      return rocker_crank_;
    case MobilityClass::double_rocker:
      return double_rocker_;
    case MobilityClass::triple_rocker:
      return triple_rocker_;
    default:
      return plain_;
  }
}

bool is_better(const FunctionFound& a, const FunctionFound& b) {
  const bool a_feasible = a.violation <= kFunctionFeasibility;
  const bool b_feasible = b.violation <= kFunctionFeasibility;
  if (a_feasible != b_feasible) return a_feasible;
  return a_feasible ? a.objective < b.objective : a.violation < b.violation;
}

bool FunctionRules::is_same(const FunctionFound& known, const FunctionFound& other,
                            double tolerance) {
  return known.problem == other.problem &&
         problems::is_same(known.generator, other.generator, tolerance);
}

/// Exact synthesis led there too.
void FunctionRules::absorb(FunctionFound& known, const FunctionFound& same) {
  if (known.origin == StartOrigin::search) known.origin = same.origin;
}

double FunctionRules::value(const FunctionFound& found) {
  return found.violation <= kFunctionFeasibility ? found.objective
                                                 : std::numeric_limits<double>::infinity();
}

bool FunctionRules::is_near(const FunctionFound& best, const FunctionFound& other) {
  return other.objective <= std::max(kMetExactly, (1 + kSameObjective) * best.objective);
}

bool FunctionRefiner::confine(FunctionFound& found) const {
  if (found.problem != &confined_.plain()) return false;
  found.problem = &confined_.of(found.generator.links);
  if (found.problem == &confined_.plain()) return false;
  found.valid = false;
  return true;
}

void FunctionRefiner::refine(FunctionFound& found, const FunctionSamples& wanted,
                             synthesis::Objective objective, synthesis::Solver solver,
                             int iterations) const {
  confine(found);
  FunctionFound stayed = found;
  refine_once(found, wanted, objective, solver, iterations);
  if (!confine(found)) return;
  refine_once(found, wanted, objective, solver, iterations);
  stay(stayed);
  refine_once(stayed, wanted, objective, solver, iterations);
  if (stayed.valid && (!found.valid || is_better(stayed, found))) found = stayed;
}

void FunctionRefiner::stay(FunctionFound& found) const {
  found.problem = &confined_.staying(found.generator.links);
  found.valid = false;
}

void FunctionRefiner::refine_once(FunctionFound& found, const FunctionSamples& wanted,
                                  synthesis::Objective objective, synthesis::Solver solver,
                                  int iterations) const {
  const Solve& asked = confined_.plain().solve;
  const bool guards = can_solve(solver, {.objective = objective, .constraints = true});
  const FunctionModel model(*found.problem, wanted, found.generator.assembly, objective,
                            guards ? Closing::guarded : Closing::unguarded);
  if (!synthesis::can_solve(solver, model)) return;
  const synthesis::Solution solution = solve_by_loss(
      solver, model, asked.loss, asked.loss_scale, 1, model.variables_of(found.generator),
      synthesis::until(deadline_, {.tolerance = asked.tolerance.value_or(kDefaultTolerance),
                                   .feasibility = 0.1 * kFunctionFeasibility,
                                   .max_iterations = iterations,
                                   .seed = run_.seed}));
  solved_.count(solution, wanted.samples.size());
  if (solution.stop == synthesis::Stop::no_value) return;
  FunctionFound next = found;
  next.generator = model.generator(solution.x);
  next.objective = solution.objective;
  next.violation = solution.violation;
  next.valid = true;
  if (!found.valid || !is_better(found, next)) found = next;
}

}  // namespace cognate::problems
