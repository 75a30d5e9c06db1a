#include "synthesis/optimise/solver.hpp"

#include <algorithm>
#include <utility>

#include "synthesis/optimise/backends.hpp"
#include "synthesis/optimise/gauss_newton.hpp"

namespace cognate::synthesis {
namespace {

/// A limit of the library (ags::solverMaxDim).
constexpr int kMostUnknownsOfAgs = 10;

Outcome minimise(Backend backend, DenseModel& model, const Options& options) {
  switch (backend) {
    case Backend::ceres:
      return minimise_with_ceres(model, options);
    case Backend::ipopt:
      return minimise_with_ipopt(model, options);
    default:
      return minimise_with_nlopt(backend, model, options);
  }
}

Solution solve_dense(Backend backend, const Model& model, std::span<const double> start,
                     const Options& options) {
  DenseModel dense(model, start, options);
  if (const auto stop = dense.stop_at_start()) return dense.finish(*stop, 0, {});
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
    case Backend::mma:
      return "mma";
    case Backend::ccsaq:
      return "ccsaq";
    case Backend::cobyla:
      return "cobyla";
    case Backend::bobyqa:
      return "bobyqa";
    case Backend::ags:
      return "ags";
    case Backend::isres:
      return "isres";
    case Backend::crs:
      return "crs";
    case Backend::mlsl:
      return "mlsl";
    case Backend::direct:
      return "direct";
    case Backend::ipopt:
      return "ipopt";
  }
  return "unknown";
}

bool is_global(Backend backend) {
  switch (backend) {
    case Backend::ags:
    case Backend::isres:
    case Backend::crs:
    case Backend::mlsl:
    case Backend::direct:
      return true;
    default:
      return false;
  }
}

bool can_solve(Backend backend, const Model& model) {
  if (backend == Backend::ceres) {
    return model.constraint_count() == 0 && model.objective() == Objective::sum_of_squares;
  }
  if (backend != Backend::ags) return true;
  const auto free = [](const Variable& variable) { return variable.lower < variable.upper; };
  return std::ranges::count_if(model.variables(), free) <= kMostUnknownsOfAgs;
}

Solution solve(Backend backend, const Model& model, std::span<const double> start,
               const Options& options) {
  if (backend == Backend::gauss_newton) return solve_gauss_newton(model, start, options);
  if (!can_solve(backend, model)) {
    Solution refused = DenseModel(model, start, options).finish(Stop::failed, 0, {});
    refused.stop = Stop::failed;  // even where the start is infeasible: nothing was tried
    return refused;
  }
  return is_global(backend) ? search_globally(backend, model, start, options)
                            : solve_dense(backend, model, start, options);
}

}  // namespace cognate::synthesis
