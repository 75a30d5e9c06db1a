/// The quadratic programs of the steps of Gauss-Newton.
#include <algorithm>
#include <cmath>

#include "synthesis/optimise/gauss_newton_descent.hpp"

namespace cognate::synthesis {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

}  // namespace

/// The normal equations of the damped step with the local variables eliminated.
void GaussNewtonDescent::reduce_least_squares(double damping) {
  hessian_.noalias() = jacobian_.transpose() * jacobian_;
  gradient_.noalias() = jacobian_.transpose() * now_.residuals;
  if (locals_ > 0) {
    local_square_.setZero();
    local_rhs_.setZero();
    local_rows_.setZero();
    for (Index row = 0; row < rows_; ++row) {
      const Index local = local_of_row_[row];
      if (local < 0) continue;
      local_square_[local] += local_slope_[row] * local_slope_[row];
      local_rhs_[local] += local_slope_[row] * now_.residuals[row];
      local_rows_.row(local) += local_slope_[row] * jacobian_.row(row);
    }
    for (Index local = 0; local < locals_; ++local) {
      const double inverse = 1 / (local_square_[local] * (1 + damping) + 1e-300);
      hessian_.noalias() -= inverse * local_rows_.row(local).transpose() * local_rows_.row(local);
      gradient_ -= (inverse * local_rhs_[local]) * local_rows_.row(local).transpose();
    }
  }
  const double floor = 1e-14 * largest_square() + 1e-300;
  hessian_.diagonal() += damping * diagonal_ + VectorXd::Constant(globals_, floor);
}

/// Madsen's step: the last unknown is the bound t ≥ 0 on all |rᵢ + Jᵢ dx|. In place of t it
/// minimises t + t²/2m, m the largest residual now: as good where t ≥ 0, and strictly convex.
void GaussNewtonDescent::reduce_minimax(double damping) {
  const double largest = std::max(largest_square(), 1e-300);
  const double size = std::max(now_.cost, 1e-300);
  hessian_.setZero(globals_ + 1, globals_ + 1);
  hessian_.diagonal().head(globals_) =
      (damping / size) * diagonal_ + VectorXd::Constant(globals_, 1e-14 * largest / size);
  if (learns_) hessian_.topLeftCorner(globals_, globals_) += curvature_.matrix();
  hessian_(globals_, globals_) = 1 / size;
  gradient_.setZero(globals_ + 1);
  gradient_[globals_] = 1;
}

/// Bounds and constraints of the step as rows A dx + b ≥ 0. Violated constraints are asked to mend
/// `share` of their violation.
void GaussNewtonDescent::state_constraints(double share) {
  const Index unknowns = globals_ + (minimax_ ? 1 : 0);
  const Index most = 2 * globals_ + limits_ + (minimax_ ? 2 * rows_ : 0);
  qp_matrix_.setZero(most, unknowns);
  qp_offset_.resize(most);
  Index row = 0;
  for (Index i = 0; i < limits_; ++i, ++row) {
    qp_matrix_.row(row).head(globals_) = constraint_jacobian_.row(i);
    const double c = now_.constraints[i];
    qp_offset_[row] = c > 0 && i >= equalities_ ? c : share * c;
  }
  for (Index i = 0; i < globals_; ++i) {
    if (std::isfinite(lower_[i])) {
      qp_matrix_(row, i) = 1;
      qp_offset_[row++] = (now_.x[i] - lower_[i]) / scale_[i];
    }
    if (std::isfinite(upper_[i])) {
      qp_matrix_(row, i) = -1;
      qp_offset_[row++] = (upper_[i] - now_.x[i]) / scale_[i];
    }
  }
  for (Index i = 0; minimax_ && i < rows_; ++i) {
    for (const double side : {1.0, -1.0}) {
      qp_matrix_.row(row).head(globals_) = side * jacobian_.row(i);
      qp_matrix_(row, globals_) = 1;
      qp_offset_[row++] = side * now_.residuals[i];
    }
  }
  qp_matrix_.conservativeResize(row, unknowns);
  qp_offset_.conservativeResize(row);
}

bool GaussNewtonDescent::find_step(double damping) {
  if (minimax_) {
    reduce_minimax(damping);
  } else {
    reduce_least_squares(damping);
  }
  for (const double share : {1.0, 0.5, 0.1, 0.0}) {
    state_constraints(share);
    if (solve_program()) {
      step_locals(damping);
      return step_.change.allFinite();
    }
    if (qp_status_ == QuadraticProgram::Status::not_convex || limits_ == 0) return false;
  }
  return false;
}

/// Whether there is a solution, which then is the step.
bool GaussNewtonDescent::solve_program() {
  qp_status_ = qp_.solve(hessian_, gradient_, qp_matrix_, qp_offset_, equalities_);
  if (qp_status_ != QuadraticProgram::Status::solved) return false;
  step_.change = qp_.x().head(globals_);
  step_.multipliers = qp_.multipliers();
  step_.bound = minimax_ ? qp_.x()[globals_] : 0;
  return true;
}

void GaussNewtonDescent::step_locals(double damping) {
  for (Index local = 0; local < locals_; ++local) {
    const double along = local_rhs_[local] + local_rows_.row(local).dot(step_.change);
    local_step_[local] = -along / (local_square_[local] * (1 + damping) + 1e-300);
  }
}

/// The step of the same quadratic program with the values at `next_`, where the last step led, less
/// what that step was to change of them: a second-order correction (Fletcher 1982, "Second order
/// corrections for non-differentiable optimization").
bool GaussNewtonDescent::correct_step() {
  qp_offset_.head(limits_) = next_.constraints - constraint_jacobian_ * step_.change;
  const VectorXd residuals = next_.residuals - jacobian_ * step_.change;
  Index row = qp_offset_.size() - 2 * rows_;
  for (const double residual : residuals) {
    qp_offset_[row++] = residual;
    qp_offset_[row++] = -residual;
  }
  return solve_program() && step_.change.allFinite() && try_step();
}

/// Of the Lagrangian at `now_` with the multipliers of the step.
VectorXd GaussNewtonDescent::lagrangian_gradient() const {
  const VectorXd& multipliers = step_.multipliers;
  VectorXd of_residuals(rows_);
  Index row = multipliers.size() - 2 * rows_;
  for (double& factor : of_residuals) {
    factor = multipliers[row + 1] - multipliers[row];
    row += 2;
  }
  return jacobian_.transpose() * of_residuals -
         constraint_jacobian_.transpose() * multipliers.head(limits_);
}

/// The slope of the minimax quadratic program's t + t²/2m at its solution: its multipliers are
/// those of the problem times this.
double GaussNewtonDescent::bound_weight() const {
  return 1 + hessian_(globals_, globals_) * step_.bound;
}

}  // namespace cognate::synthesis
