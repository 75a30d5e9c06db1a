#include "synthesis/optimise/dense_model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace cognate::synthesis {
namespace {

using Eigen::Index;

}  // namespace

DenseModel::DenseModel(const Model& model, std::span<const double> start, const Options& options)
    : model_(model),
      options_(options),
      minimax_(model.objective() == Objective::max_abs),
      equalities_(model.equality_count()) {
  const std::span<const Variable> variables = model.variables();
  x_.resize(variables.size());
  for (std::size_t i = 0; i < variables.size(); ++i) {
    x_[i] = std::clamp(start[i], variables[i].lower, variables[i].upper);
    if (variables[i].lower < variables[i].upper) free_.push_back(static_cast<int>(i));
  }
  const Index n = size();
  scale_.resize(n);
  lower_.resize(n);
  upper_.resize(n);
  start_.resize(n);
  for (Index k = 0; k < n; ++k) {
    const Variable& variable = variables[free_[k]];
    scale_[k] = variable.scale;
    lower_[k] = variable.lower / variable.scale;
    upper_[k] = variable.upper / variable.scale;
    start_[k] = std::clamp(x_[free_[k]] / variable.scale, lower_[k], upper_[k]);
  }
  const int rows = model.residual_count();
  const int limits = model.constraint_count();
  y_ = start_;
  best_ = start_;
  residuals_.setZero(rows);
  constraints_.setZero(limits);
  jacobian_.setZero(rows, n);
  constraint_jacobian_.setZero(limits, n);
  global_.resize(static_cast<std::size_t>(rows) * model.global_count());
  local_.resize(model.local_count() > 0 ? rows : 0);
  constraint_global_.resize(static_cast<std::size_t>(limits) * model.global_count());
}

void DenseModel::expand(std::span<const double> y) {
  const std::span<const Variable> variables = model_.variables();
  for (Index k = 0; k < size(); ++k) {
    const Variable& variable = variables[free_[k]];
    y_[k] = y[k];
    // Undoing the scale may leave a bound by a rounding error.
    x_[free_[k]] = std::clamp(y[k] * scale_[k], variable.lower, variable.upper);
  }
}

bool DenseModel::evaluate(std::span<const double> y, bool with_derivatives) {
  const bool same = known_ && std::equal(y.begin(), y.end(), y_.begin());
  if (same && (differentiated_ || !with_derivatives || !valid_)) return valid_;
  expand(y);
  known_ = true;
  differentiated_ = with_derivatives;
  valid_ = call_model(with_derivatives);
  if (valid_ && with_derivatives) gather_derivatives();
  if (valid_) remember();
  return valid_;
}

bool DenseModel::call_model(bool with_derivatives) {
  ++evaluations_;
  if (with_derivatives) ++gradients_;
  try {
    if (constraint_count() > 0) {
      model_.constraints(
          x_, view(constraints_),
          with_derivatives ? std::span<double>(constraint_global_) : std::span<double>());
    }
    const bool has_value = with_derivatives
                               ? model_.residuals(x_, view(residuals_), global_, local_)
                               : model_.residuals(x_, view(residuals_), {}, {});
    return has_value && residuals_.allFinite() && constraints_.allFinite();
  } catch (...) {
    fault_ = std::current_exception();
    return false;
  }
}

void DenseModel::gather_derivatives() {
  const Index globals = model_.global_count();
  const auto rows = static_cast<Index>(residuals_.size());
  const Eigen::Map<const RowMatrix> global(global_.data(), rows, globals);
  const Eigen::Map<const RowMatrix> limits(constraint_global_.data(), constraint_count(), globals);
  const std::span<const int> local_of = model_.local_of_residual();
  for (Index k = 0; k < size(); ++k) {
    if (free_[k] < globals) {
      jacobian_.col(k) = scale_[k] * global.col(free_[k]);
      constraint_jacobian_.col(k) = scale_[k] * limits.col(free_[k]);
      continue;
    }
    const int local = free_[k] - static_cast<int>(globals);
    for (Index row = 0; row < rows; ++row) {
      jacobian_(row, k) = local_of[row] == local ? scale_[k] * local_[row] : 0;
    }
  }
  valid_ = jacobian_.allFinite() && constraint_jacobian_.allFinite();
}

bool DenseModel::hessian(const Eigen::VectorXd& of_residuals, const Eigen::VectorXd& of_constraints,
                         RowMatrix& out) {
  const auto all = static_cast<Index>(x_.size());
  hessian_.resize(x_.size() * x_.size());
  try {
    const bool known = model_.lagrangian_hessian(
        x_, {of_residuals.data(), static_cast<std::size_t>(of_residuals.size())},
        {of_constraints.data(), static_cast<std::size_t>(of_constraints.size())}, hessian_);
    if (!known) return false;
  } catch (...) {
    fault_ = std::current_exception();
    return false;
  }
  const Eigen::Map<const RowMatrix> whole(hessian_.data(), all, all);
  out = scale_.asDiagonal() * whole(free_, free_) * scale_.asDiagonal();
  return out.allFinite();
}

double DenseModel::objective() const {
  if (residuals_.size() == 0) return 0;
  return minimax_ ? residuals_.lpNorm<Eigen::Infinity>() : residuals_.squaredNorm();
}

double DenseModel::violation() const {
  return largest_violation(constraints_, equalities_);
}

void DenseModel::remember() {
  const double now = objective();
  const double now_violation = violation();
  const bool feasible = now_violation <= options_.feasibility;
  const bool best_feasible = best_violation_ <= options_.feasibility;
  bool better = !has_best_;
  if (has_best_) {
    if (feasible != best_feasible) {
      better = feasible;
    } else {
      better = feasible ? now < best_objective_ : now_violation < best_violation_;
    }
  }
  if (!better) return;
  has_best_ = true;
  best_ = y_;
  best_objective_ = now;
  best_violation_ = now_violation;
}

std::vector<double> DenseModel::variables_at(const Eigen::VectorXd& y) {
  known_ = false;
  expand({y.data(), static_cast<std::size_t>(y.size())});
  return x_;
}

std::optional<Stop> DenseModel::stop_at_start() {
  if (!evaluate(view(start_), false)) return Stop::no_value;
  if (const auto stop = must_stop()) return stop;
  if (size() == 0) return Stop::converged;
  return std::nullopt;
}

std::optional<Stop> DenseModel::must_stop() const {
  if (fault_) return Stop::failed;
  if (options_.interrupted && options_.interrupted->load(std::memory_order_relaxed)) {
    return Stop::interrupted;
  }
  const std::chrono::duration<double> spent = Clock::now() - begin_;
  if (spent.count() > options_.time_limit) return Stop::time_limit;
  return std::nullopt;
}

Solution DenseModel::finish(Stop stop, int iterations, std::vector<double> multipliers) {
  if (fault_) std::rethrow_exception(fault_);
  known_ = false;
  evaluate(view(best_), false);
  if (fault_) std::rethrow_exception(fault_);
  Solution solution;
  solution.x = x_;
  solution.objective = valid_ ? objective() : std::numeric_limits<double>::infinity();
  solution.violation = violation();
  const bool settled = stop == Stop::converged || stop == Stop::failed;
  if (settled && solution.violation > options_.feasibility) stop = Stop::infeasible;
  solution.multipliers = std::move(multipliers);
  solution.stop = stop;
  solution.iterations = iterations;
  solution.evaluations = evaluations_;
  solution.gradients = gradients_;
  return solution;
}

}  // namespace cognate::synthesis
