#include "synthesis/optimise/quadratic_program.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Jacobi>
#include <cmath>

#include "analysis/numbers/constants.hpp"

namespace cognate::synthesis {
namespace {

using Eigen::Index;

}  // namespace

void QuadraticProgram::resize(Index n, Index m) {
  j_.resize(n, n);
  r_.resize(n, n);
  d_.resize(n);
  z_.resize(n);
  u_step_.resize(n + 1);
  u_.resize(n + 1);
  x_.resize(n);
  multipliers_.resize(m);
  active_.resize(n + 1);
}

bool QuadraticProgram::factor(const Eigen::Ref<const Eigen::MatrixXd>& hessian) {
  // In place: j_ holds the Cholesky factor, then its inverse transposed.
  r_ = hessian;
  Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> cholesky(r_);
  if (cholesky.info() != Eigen::Success) return false;
  j_.setIdentity();
  cholesky.matrixU().solveInPlace(j_);
  return true;
}

/// d = Jᵀn; z: the step in x that keeps the active constraints; u_step: how their multipliers fall.
void QuadraticProgram::step_directions(const Eigen::Ref<const Eigen::VectorXd>& normal) {
  const Index n = x_.size(), q = active_count_;
  d_.noalias() = j_.transpose() * normal;
  z_.noalias() = j_.rightCols(n - q) * d_.tail(n - q);
  u_step_.head(q) = d_.head(q);
  r_.topLeftCorner(q, q).triangularView<Eigen::Upper>().solveInPlace(u_step_.head(q));
}

/// Appends the normal whose d_ was just computed; false if it depends on the active ones.
bool QuadraticProgram::add_constraint(Index constraint) {
  const Index n = x_.size(), q = active_count_;
  for (Index k = n - 1; k > q; --k) {
    Eigen::JacobiRotation<double> rotation;
    rotation.makeGivens(d_[k - 1], d_[k], &d_[k - 1]);
    d_[k] = 0;
    j_.applyOnTheRight(k - 1, k, rotation);
  }
  if (std::abs(d_[q]) <= 1e-14 * d_.head(q + 1).norm()) return false;
  r_.col(q).head(q + 1) = d_.head(q + 1);
  active_[q] = constraint;
  ++active_count_;
  return true;
}

void QuadraticProgram::drop_constraint(Index position) {
  for (Index k = position; k + 1 < active_count_; ++k) {
    active_[k] = active_[k + 1];
    u_[k] = u_[k + 1];
    r_.col(k).head(k + 2) = r_.col(k + 1).head(k + 2);
  }
  u_[active_count_ - 1] = u_[active_count_];
  --active_count_;
  for (Index k = position; k < active_count_; ++k) {
    Eigen::JacobiRotation<double> rotation;
    rotation.makeGivens(r_(k, k), r_(k + 1, k), &r_(k, k));
    r_(k + 1, k) = 0;
    for (Index column = k + 1; column < active_count_; ++column) {
      const double upper = r_(k, column), lower = r_(k + 1, column);
      r_(k, column) = rotation.c() * upper - rotation.s() * lower;
      r_(k + 1, column) = rotation.s() * upper + rotation.c() * lower;
    }
    j_.applyOnTheRight(k, k + 1, rotation);
  }
}

/// Steps onto the equalities, one after another; false where they contradict each other. One that
/// follows from those before it is left out.
bool QuadraticProgram::add_equalities(const Eigen::Ref<const Eigen::MatrixXd>& matrix,
                                      const Eigen::Ref<const Eigen::VectorXd>& offset,
                                      Index equalities, double tolerance) {
  const Index n = x_.size();
  for (Index i = 0; i < equalities; ++i) {
    const double slack = matrix.row(i).dot(x_) + offset[i];
    step_directions(matrix.row(i).transpose());
    const Index q = active_count_;
    if (q == n || d_.tail(n - q).norm() <= 1e-12 * d_.norm()) {
      if (std::abs(slack) > tolerance * (1 + std::abs(offset[i]))) return false;
      continue;
    }
    const double step = -slack / z_.dot(matrix.row(i));
    x_ += step * z_;
    u_.head(q) -= step * u_step_.head(q);
    u_[q] = step;
    if (!add_constraint(i)) return false;
  }
  return true;
}

QuadraticProgram::Status QuadraticProgram::solve(const Eigen::Ref<const Eigen::MatrixXd>& hessian,
                                                 const Eigen::Ref<const Eigen::VectorXd>& gradient,
                                                 const Eigen::Ref<const Eigen::MatrixXd>& matrix,
                                                 const Eigen::Ref<const Eigen::VectorXd>& offset,
                                                 Index equalities, double tolerance) {
  const Index n = gradient.size(), m = offset.size();
  resize(n, m);
  multipliers_.setZero();
  active_count_ = 0;
  if (!factor(hessian)) return Status::not_convex;
  d_.noalias() = j_.transpose() * gradient;
  x_.noalias() = -(j_ * d_);

  if (!add_equalities(matrix, offset, equalities, tolerance)) return Status::infeasible;
  const Index kept = active_count_;  // equalities are never dropped
  const Index limit = 10 * (n + m) + 20;
  for (Index round = 0; round < limit; ++round) {
    Index worst = -1;
    double least = 0;
    for (Index i = equalities; i < m; ++i) {
      if ((active_.head(active_count_).array() == i).any()) continue;
      const double slack = matrix.row(i).dot(x_) + offset[i];
      if (slack < -tolerance * (1 + std::abs(offset[i])) && slack < least) {
        least = slack;
        worst = i;
      }
    }
    if (worst < 0) {
      for (Index k = 0; k < active_count_; ++k) multipliers_[active_[k]] = u_[k];
      return Status::solved;
    }

    u_[active_count_] = 0;
    for (;;) {
      step_directions(matrix.row(worst).transpose());
      Index blocking = -1;
      double dual_step = kInfinity;
      for (Index k = kept; k < active_count_; ++k) {
        if (u_step_[k] > 0 && u_[k] / u_step_[k] < dual_step) {
          dual_step = u_[k] / u_step_[k];
          blocking = k;
        }
      }
      const double curvature = z_.dot(matrix.row(worst));
      const bool independent =
          active_count_ < n && d_.tail(n - active_count_).norm() > 1e-12 * d_.norm();
      const double slack = matrix.row(worst).dot(x_) + offset[worst];
      const double primal_step = independent ? -slack / curvature : kInfinity;
      const double step = std::min(primal_step, dual_step);
      if (step == kInfinity) return Status::infeasible;
      if (independent) x_ += step * z_;
      u_.head(active_count_) -= step * u_step_.head(active_count_);
      u_[active_count_] += step;
      if (step == primal_step) {
        if (!add_constraint(worst)) return Status::infeasible;
        break;
      }
      drop_constraint(blocking);
    }
  }
  return Status::iteration_limit;
}

}  // namespace cognate::synthesis
