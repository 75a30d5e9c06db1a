#include "synthesis/optimise/solver.hpp"

#include <utility>

#include "synthesis/optimise/backends.hpp"
#include "synthesis/optimise/gauss_newton.hpp"

namespace cognate::synthesis {
namespace {

Outcome minimise(Backend backend, DenseModel& model, const Options& options) {
  switch (backend) {
    case Backend::ceres:
      return minimise_with_ceres(model, options);
    case Backend::slsqp:
      return minimise_with_slsqp(model, options);
    case Backend::cobyla:
      return minimise_with_cobyla(model, options);
    case Backend::ipopt:
      return minimise_with_ipopt(model, options);
    case Backend::gauss_newton:
      break;  // has its own way in
  }
  return {};
}

Solution solve_dense(Backend backend, const Model& model, std::span<const double> start,
                     const Options& options) {
  DenseModel dense(model, start, options);
  const Eigen::VectorXd& y = dense.start();
  if (!dense.evaluate({y.data(), static_cast<std::size_t>(y.size())}, false)) {
    return dense.finish(Stop::no_value, 0, {});
  }
  if (const auto stop = dense.must_stop()) return dense.finish(*stop, 0, {});
  if (dense.size() == 0) return dense.finish(Stop::converged, 0, {});
  Outcome outcome = minimise(backend, dense, options);
  return dense.finish(outcome.stop, outcome.iterations, std::move(outcome.multipliers));
}

}  // namespace

std::string_view name(Backend backend) {
  switch (backend) {
    case Backend::gauss_newton:
      return "gauss-newton";
    case Backend::ceres:
      return "ceres";
    case Backend::slsqp:
      return "slsqp";
    case Backend::cobyla:
      return "cobyla";
    case Backend::ipopt:
      return "ipopt";
  }
  return "unknown";
}

bool can_solve(Backend backend, const Model& model) {
  return backend != Backend::ceres ||
         (model.constraint_count() == 0 && model.objective() == Objective::sum_of_squares);
}

Solution solve(Backend backend, const Model& model, std::span<const double> start,
               const Options& options) {
  if (backend == Backend::gauss_newton) return solve_gauss_newton(model, start, options);
  if (!can_solve(backend, model)) {
    Solution refused = DenseModel(model, start, options).finish(Stop::failed, 0, {});
    refused.stop = Stop::failed;  // even where the start is infeasible: nothing was tried
    return refused;
  }
  return solve_dense(backend, model, start, options);
}

}  // namespace cognate::synthesis
