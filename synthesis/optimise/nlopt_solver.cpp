#include <nlopt.h>

#include <Eigen/Core>
#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "synthesis/optimise/backends.hpp"
#include "synthesis/optimise/program.hpp"

namespace cognate::synthesis {
namespace {

using Handle = std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)>;

/// What the callbacks share. NLopt counts evaluations only; an iteration is a gradient here, or for
/// a method without gradients as many evaluations as a gradient by differences would take.
struct Search {
  Program& program;
  const Options& options;
  bool with_gradients;
  nlopt_opt handle = nullptr;
  int evaluations = 0;
  int gradients = 0;
  double worst = 1;  ///< largest objective seen
  std::optional<Stop> stop;

  int iterations() const { return with_gradients ? gradients : evaluations / (program.size() + 1); }
};

void heed_limits(Search& search) {
  search.stop = search.program.model().must_stop();
  if (!search.stop && search.iterations() >= search.options.max_iterations) {
    search.stop = Stop::iteration_limit;
  }
  if (search.stop) nlopt_force_stop(search.handle);
}

double objective(unsigned n, const double* z, double* gradient, void* data) {
  auto& search = *static_cast<Search*>(data);
  Program& program = search.program;
  ++search.evaluations;
  if (gradient) ++search.gradients;
  const bool valid = program.evaluate({z, n}, search.with_gradients);
  heed_limits(search);
  if (!valid) {
    // No linkage here: worse than any point that has a value, which turns the line search back. A
    // NaN would be taken for a step (NLopt 2.7), an infinity spoils COBYLA's linear models.
    if (gradient) std::fill_n(gradient, n, 0.0);
    return 10 * search.worst;
  }
  if (gradient) program.gradient({gradient, n});
  search.worst = std::max(search.worst, program.objective());
  return program.objective();
}

/// NLopt wants c ≤ 0.
void constraints(unsigned m, double* c, unsigned n, const double* z, double* jacobian, void* data) {
  auto& search = *static_cast<Search*>(data);
  Program& program = search.program;
  const std::size_t entries = std::size_t{m} * n;
  const bool valid = program.evaluate({z, n}, search.with_gradients);
  if (!valid && program.epigraph()) {
    std::fill_n(c, m, 10 * search.worst);
  } else {
    program.constraints({c, m});
    std::transform(c, c + m, c, std::negate<>());
  }
  if (!jacobian) return;
  if (!valid) {
    std::fill_n(jacobian, entries, 0.0);
    return;
  }
  program.constraint_jacobian({jacobian, entries});
  std::transform(jacobian, jacobian + entries, jacobian, std::negate<>());
}

Stop stop_of(nlopt_result result) {
  switch (result) {
    case NLOPT_SUCCESS:
    case NLOPT_STOPVAL_REACHED:
    case NLOPT_FTOL_REACHED:
    case NLOPT_XTOL_REACHED:
    case NLOPT_ROUNDOFF_LIMITED:
      return Stop::converged;
    default:
      return Stop::failed;
  }
}

/// One run of the algorithm from the start of the program.
Stop run(nlopt_algorithm algorithm, Search& search) {
  Program& program = search.program;
  const auto n = static_cast<unsigned>(program.size());
  const auto m = static_cast<unsigned>(program.constraint_count());
  const Handle handle(nlopt_create(algorithm, n), &nlopt_destroy);
  search.handle = handle.get();
  search.worst = 1;
  nlopt_set_min_objective(handle.get(), objective, &search);
  nlopt_set_lower_bounds(handle.get(), program.lower().data());
  nlopt_set_upper_bounds(handle.get(), program.upper().data());
  if (m > 0) {
    const std::vector<double> tolerances(m, 0.1 * search.options.feasibility);
    nlopt_add_inequality_mconstraint(handle.get(), m, constraints, &search, tolerances.data());
  }
  nlopt_set_ftol_rel(handle.get(), search.options.tolerance);
  // For COBYLA this is the final radius of the simplex; below it, it works on rounding errors.
  nlopt_set_xtol_rel(handle.get(), search.with_gradients ? 1e-15 : 1e-11);
  Eigen::VectorXd z = program.start();
  double least = 0;
  const Stop stop = stop_of(nlopt_optimize(handle.get(), z.data(), &least));
  return search.stop.value_or(stop);
}

Outcome minimise(nlopt_algorithm algorithm, bool with_gradients, DenseModel& model,
                 const Options& options) {
  Program program(model);
  Search search{program, options, with_gradients};
  const Stop stop = run(algorithm, search);
  return {stop, search.iterations(), {}};
}

}  // namespace

Outcome minimise_with_slsqp(DenseModel& model, const Options& options) {
  return minimise(NLOPT_LD_SLSQP, true, model, options);
}

Outcome minimise_with_cobyla(DenseModel& model, const Options& options) {
  return minimise(NLOPT_LN_COBYLA, false, model, options);
}

}  // namespace cognate::synthesis
