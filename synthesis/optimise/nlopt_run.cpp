#include "synthesis/optimise/nlopt_run.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace cognate::synthesis {
namespace {

using Handle = std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)>;
using Known = NloptMethod::Constraints;

constexpr double kNoValueOfGlobal = 2;
/// AGS takes at most so many constraints.
constexpr int kFew = 10;
/// How many searches the augmented Lagrangian divides the evaluations of a global one into.
constexpr int kMultiplierUpdates = 5;
constexpr int kEvaluationsOfLocalSearch = 200;
/// What an iteration of a method with gradients evaluates at most, on average. SLSQP's own line
/// searches take ten; where constraints contradict one another it may go on with them for ever.
constexpr int kMostOfIteration = 20;
/// Step to begin with for those methods to which NLopt would give one by the bounds, which may be
/// thousands of scales apart.
constexpr double kFirstStep = 0.25;

/// What the callbacks share.
struct Search {
  const NloptMethod& method;
  Program& program;
  const Options& options;
  int most_evaluations;
  nlopt_opt handle = nullptr;
  int evaluations = 0;
  int gradients = 0;
  double worst = 1;  ///< largest objective seen
  std::optional<Stop> stop;

  int iterations() const {
    if (!method.with_gradients) return evaluations / (program.size() + 1);
    return std::max(gradients, evaluations / kMostOfIteration);
  }
  double no_value() const { return method.global ? kNoValueOfGlobal : 10 * worst; }
};

void heed_limits(Search& search) {
  search.stop = search.program.model().must_stop();
  const bool used_up = search.most_evaluations > 0
                           ? search.evaluations >= search.most_evaluations
                           : search.iterations() >= search.options.max_iterations;
  if (!search.stop && used_up) {
    search.stop = search.method.global ? Stop::converged : Stop::iteration_limit;
  }
  if (search.stop) nlopt_force_stop(search.handle);
}

/// f/(1 + f) and its gradient in place of f and its own.
double compressed(double f, double* gradient, unsigned n) {
  const double share = 1 / (1 + f);
  if (gradient) {
    std::transform(gradient, gradient + n, gradient, [=](double g) { return g * share * share; });
  }
  return f * share;
}

double objective(unsigned n, const double* z, double* gradient, void* data) {
  auto& search = *static_cast<Search*>(data);
  Program& program = search.program;
  // An inner search may not hear of the stop: nothing is evaluated for it any more.
  bool valid = false;
  if (!search.stop) {
    ++search.evaluations;
    if (gradient) ++search.gradients;
    valid = program.evaluate({z, n}, search.method.with_gradients);
    heed_limits(search);
  }
  if (!valid) {
    // A NaN would be taken for a step (NLopt 2.7), an infinity spoils COBYLA's linear models.
    if (gradient) std::fill_n(gradient, n, 0.0);
    return search.no_value();
  }
  if (gradient) program.gradient({gradient, n});
  const double f = program.objective();
  search.worst = std::max(search.worst, f);
  return search.method.global ? compressed(f, gradient, n) : f;
}

/// All constraints of the program at z; NLopt requires c ≤ 0.
void all_constraints(Search& search, const double* z, std::span<double> c,
                     std::span<double> jacobian) {
  Program& program = search.program;
  const auto n = static_cast<std::size_t>(program.size());
  // AGS evaluates the objective only where all constraints hold, perhaps never.
  if (!search.stop) heed_limits(search);
  const bool valid = !search.stop && program.evaluate({z, n}, search.method.with_gradients);
  if (!valid && (program.epigraph() || search.stop)) {
    std::ranges::fill(c, search.no_value());
  } else {
    program.constraints(c);
    std::ranges::transform(c, c.begin(), std::negate<>());
  }
  if (jacobian.empty()) return;
  if (!valid) {
    std::ranges::fill(jacobian, 0.0);
    return;
  }
  program.constraint_jacobian(jacobian);
  std::ranges::transform(jacobian, jacobian.begin(), std::negate<>());
}

/// Rows [first, first + m) of the constraints.
template <bool Equalities>
void constraints(unsigned m, double* out, unsigned n, const double* z, double* jacobian,
                 void* data) {
  auto& search = *static_cast<Search*>(data);
  const auto all = static_cast<std::size_t>(search.program.constraint_count());
  const std::size_t first = Equalities ? 0 : search.program.equality_count();
  std::vector<double> c(all), slopes(jacobian ? all * n : 0);
  all_constraints(search, z, c, slopes);
  std::copy_n(c.begin() + first, m, out);
  if (jacobian) std::copy_n(slopes.begin() + first * n, std::size_t{m} * n, jacobian);
}

/// One constraint by itself, for AGS, which has no gradients.
struct Single {
  Search* search;
  int row;
};

double single_constraint(unsigned, const double* z, double*, void* data) {
  const auto& [search, row] = *static_cast<Single*>(data);
  std::vector<double> c(search->program.constraint_count());
  all_constraints(*search, z, c, {});
  return c[row];
}

void add_constraints(nlopt_opt handle, Search& search) {
  const auto equalities = static_cast<unsigned>(search.program.equality_count());
  const unsigned others = search.program.constraint_count() - equalities;
  const std::vector<double> tolerances(equalities + others, 0.1 * search.options.feasibility);
  if (equalities > 0) {
    nlopt_add_equality_mconstraint(handle, equalities, constraints<true>, &search,
                                   tolerances.data());
  }
  if (others > 0) {
    nlopt_add_inequality_mconstraint(handle, others, constraints<false>, &search,
                                     tolerances.data());
  }
}

bool knows_constraints(const Search& search) {
  const int count = search.program.constraint_count();
  const int equalities = search.program.equality_count();
  switch (search.method.constraints) {
    case Known::none:
      return count == 0;
    case Known::few_inequalities:
      return count <= kFew && equalities == 0;
    case Known::all:
      return true;
  }
  return false;
}

Handle create(nlopt_algorithm algorithm, const Search& search, const NloptLimits& limits) {
  const auto n = static_cast<unsigned>(search.program.size());
  Handle handle(nlopt_create(algorithm, n), &nlopt_destroy);
  nlopt_set_lower_bounds(handle.get(), limits.lower.data());
  nlopt_set_upper_bounds(handle.get(), limits.upper.data());
  if (search.method.global) return handle;
  nlopt_set_ftol_rel(handle.get(), search.options.tolerance);
  // For COBYLA this is the final radius of the simplex; below it, it works on rounding errors.
  nlopt_set_xtol_rel(handle.get(), search.method.with_gradients ? 1e-15 : 1e-11);
  if (algorithm == NLOPT_LN_BOBYQA) {
    const Eigen::VectorXd room = 0.25 * (limits.upper - limits.lower);
    const Eigen::VectorXd step = room.cwiseMin(kFirstStep);
    nlopt_set_initial_step(handle.get(), step.data());
  }
  return handle;
}

/// The method itself where it knows the program's constraints, else the augmented Lagrangian
/// around it.
Handle create_whole(Search& search, const NloptLimits& limits) {
  Handle inner = create(search.method.algorithm, search, limits);
  if (search.method.local != search.method.algorithm) {
    const Handle local = create(search.method.local, search, limits);
    nlopt_set_ftol_rel(local.get(), 1e-6);
    nlopt_set_xtol_rel(local.get(), 1e-6);
    nlopt_set_maxeval(local.get(), kEvaluationsOfLocalSearch);
    nlopt_set_local_optimizer(inner.get(), local.get());
  }
  if (knows_constraints(search)) return inner;
  if (limits.evaluations > 0) {
    nlopt_set_maxeval(inner.get(), std::max(1, limits.evaluations / kMultiplierUpdates));
  }
  Handle outer = create(NLOPT_AUGLAG, search, limits);
  nlopt_set_local_optimizer(outer.get(), inner.get());
  return outer;
}

Stop stop_of(nlopt_result result) {
  switch (result) {
    case NLOPT_SUCCESS:
    case NLOPT_STOPVAL_REACHED:
    case NLOPT_FTOL_REACHED:
    case NLOPT_XTOL_REACHED:
    case NLOPT_MAXEVAL_REACHED:
    case NLOPT_ROUNDOFF_LIMITED:
      return Stop::converged;
    default:
      return Stop::failed;
  }
}

}  // namespace

Outcome run_nlopt(const NloptMethod& method, Program& program, const NloptLimits& limits,
                  const Options& options) {
  Search search{method, program, options, limits.evaluations};
  // NLopt's generator belongs to the thread.
  nlopt_srand(static_cast<unsigned long>(options.seed ^ (options.seed >> 32)));
  const Handle handle = create_whole(search, limits);
  search.handle = handle.get();
  nlopt_set_min_objective(handle.get(), objective, &search);
  if (limits.evaluations > 0) nlopt_set_maxeval(handle.get(), limits.evaluations);
  if (std::isfinite(options.time_limit)) {
    nlopt_set_maxtime(handle.get(), std::max(options.time_limit, 1e-6));
  }
  std::vector<Single> singles;
  const bool one_by_one = method.constraints == Known::few_inequalities;
  if (one_by_one && knows_constraints(search)) {
    for (int row = 0; row < program.constraint_count(); ++row) singles.push_back({&search, row});
    for (Single& single : singles) {
      nlopt_add_inequality_constraint(handle.get(), single_constraint, &single,
                                      0.1 * options.feasibility);
    }
  } else {
    add_constraints(handle.get(), search);
  }
  Eigen::VectorXd z = program.start().cwiseMax(limits.lower).cwiseMin(limits.upper);
  double least = 0;
  const Stop stop = stop_of(nlopt_optimize(handle.get(), z.data(), &least));
  return {search.stop.value_or(stop), search.iterations(), {}, std::move(z)};
}

}  // namespace cognate::synthesis
