/// @file Solvers: each takes a model, a start and options, and returns a point and why it stopped.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

#include "synthesis/optimise/model.hpp"

namespace cognate::synthesis {

/// Every way out of a solver.
enum class Stop {
  converged,        ///< the solver's own test of optimality or of stagnation was met
  iteration_limit,  ///< `max_iterations` was reached
  time_limit,       ///< `time_limit` seconds had passed
  interrupted,      ///< `interrupted` became true
  no_value,         ///< the model has no value at the start
  infeasible,       ///< the solver ended at a point that violates the constraints
  failed,           ///< numerical difficulties; `x` is the best point seen
};

/// When a solver stops.
struct Options {
  double tolerance = 1e-12;   ///< relative change of the objective at which to stop
  double feasibility = 1e-9;  ///< largest violation of a constraint that counts as met
  int max_iterations = 200;
  double time_limit = std::numeric_limits<double>::infinity();  ///< seconds
  const std::atomic<bool>* interrupted = nullptr;
  std::uint64_t seed = 0;  ///< of the searches that draw random numbers (isres, crs, mlsl)
  /// Evaluations that a global search may take before its best point is refined; 0: a thousand for
  /// each unknown and one thousand more.
  std::uint64_t search_evaluations = 0;
  /// A warm start: multipliers of the constraints at the start, as a Solution has them.
  /// Gauss-Newton sets its penalties by them; Ipopt, on sums of squares, begins near the central
  /// path's end. The others begin anew.
  std::span<const double> multipliers = {};
  /// Of Gauss-Newton on largest residuals without local unknowns: it learns the curvature of the
  /// Lagrangian from its steps and corrects steps that fall short to second order. It then ends
  /// nearer to minima at which few residuals are the largest.
  bool learns_curvature = false;
};

/// Where a solver ended, and why.
struct Solution {
  std::vector<double> x;
  double objective = 0;  ///< ‖r‖² or max |r|, by the model's objective
  double violation = 0;  ///< largest max(0, −c) and excess over the bounds, re-evaluated at x
  std::vector<double> multipliers;  ///< of the constraints, where the solver has them
  Stop stop = Stop::failed;
  int iterations = 0;             ///< of a global search: those that refined its best point
  std::uint64_t evaluations = 0;  ///< of the residuals
  std::uint64_t gradients = 0;    ///< of their Jacobian
};

/// The solvers: our own; Ceres; of NLopt first those that descend from the start, then the global
/// searches (Johnson, "The NLopt nonlinear-optimization package"); Ipopt.
///
/// Ceres minimises sums of squares within bounds and refuses models with other constraints or a
/// minimax objective; AGS takes ten unknowns at most (`can_solve` says which models they take). The
/// others take every model: constraints that an algorithm does not know enter its objective by an
/// augmented Lagrangian.
enum class Solver {
  automatic,  ///< Gauss-Newton, unless who asks knows better for the kind of problem
  gauss_newton,
  ceres,
  slsqp,   ///< Kraft 1988: sequential quadratic programming
  mma,     ///< Svanberg 2002: moving asymptotes
  ccsaq,   ///< Svanberg 2002: conservative separable quadratic models
  cobyla,  ///< Powell 1994: linear models, without derivatives
  bobyqa,  ///< Powell 2009: quadratic models, without derivatives
  ags,     ///< Sergeyev & Markin 1995: intervals along a space-filling curve
  isres,   ///< Runarsson & Yao 2005: evolution strategy with stochastic ranking
  crs,     ///< Kaelo & Ali 2006: controlled random search with local mutation
  mlsl,    ///< Rinnooy Kan & Timmer 1987, Kucherenko & Sytsko 2005: single linkage, Sobol' points
  direct,  ///< Gablonsky & Kelley 2001: dividing rectangles, locally biased
  ipopt,
};

/// What is said once of a solver.
struct SolverDeclaration {
  Solver id;
  std::string_view name;  ///< as files and results write it
  std::string_view meaning;
  bool is_global = false;  ///< see `is_global`
};

/// In the order of `Solver`.
inline constexpr std::array kSolvers{
    SolverDeclaration{Solver::automatic, "auto", "the one that suits the problem"},
    SolverDeclaration{Solver::gauss_newton, "gauss-newton",
                      "Gauss-Newton with constraints, made for linkages"},
    SolverDeclaration{Solver::ceres, "ceres",
                      "Levenberg-Marquardt (Ceres): least squares within bounds only"},
    SolverDeclaration{Solver::slsqp, "slsqp", "sequential quadratic programming (NLopt)"},
    SolverDeclaration{Solver::mma, "mma", "method of moving asymptotes (NLopt)"},
    SolverDeclaration{Solver::ccsaq, "ccsaq", "conservative separable quadratic models (NLopt)"},
    SolverDeclaration{Solver::cobyla, "cobyla", "linear models without derivatives (NLopt)"},
    SolverDeclaration{Solver::bobyqa, "bobyqa", "quadratic models without derivatives (NLopt)"},
    SolverDeclaration{Solver::ags, "ags",
                      "global: intervals on a space-filling curve, ten unknowns at most (NLopt)",
                      true},
    SolverDeclaration{Solver::isres, "isres",
                      "global: evolution strategy with stochastic ranking (NLopt)", true},
    SolverDeclaration{Solver::crs, "crs", "global: controlled random search (NLopt)", true},
    SolverDeclaration{Solver::mlsl, "mlsl",
                      "global: multi-level single linkage of local searches (NLopt)", true},
    SolverDeclaration{Solver::direct, "direct", "global: dividing rectangles (NLopt)", true},
    SolverDeclaration{Solver::ipopt, "ipopt", "interior point (Ipopt)"}};

static_assert([] {
  for (std::size_t i = 0; i < kSolvers.size(); ++i) {
    if (static_cast<std::size_t>(kSolvers[i].id) != i) return false;
  }
  return true;
}());

/// As files name it: "auto", "gauss-newton"; empty for a number that is no solver.
std::string_view name(Solver solver);

/// `solver`, or `otherwise` where it is automatic.
constexpr Solver chosen(Solver solver, Solver otherwise = Solver::gauss_newton) {
  return solver == Solver::automatic ? otherwise : solver;
}

/// Whether `solver` searches a box for its global minimum. The box is that of the variables'
/// bounds; a bound that is infinite, or more than 100 scales from the start, is replaced by one 10
/// scales from the start. Its best point is then refined: a sum of squares by Gauss-Newton, max |r|
/// by SLSQP. The same seed gives the same result.
bool is_global(Solver solver);

/// What of a model can be beyond a solver.
struct Requirements {
  Objective objective = Objective::sum_of_squares;
  bool constraints = false;  ///< other than bounds of variables
  std::int64_t unknowns = 0;
};

/// Whether `solver` can honour everything that is required.
bool can_solve(Solver solver, const Requirements& required);
bool can_solve(Solver solver, const Model& model);

/// Whether `solver` sees an objective through its linearised residuals alone, which suits sums of
/// squares and not an objective that is none.
bool linearises_residuals(Solver solver);

/// The most unknowns that `solver` can have.
std::int64_t most_unknowns(Solver solver);

/// Whether `solver` eliminates the local unknowns of a model (`Model::local_of_residual`), so that
/// any number of them costs little. The matrices of the others are full.
bool eliminates_locals(Solver solver);

/// The local minimum of `model` that `solver` reaches from `start` (clamped to the bounds), or the
/// best that a global search knows of, which is never worse than the start.
Solution solve(Solver solver, const Model& model, std::span<const double> start,
               const Options& options = {});

}  // namespace cognate::synthesis
