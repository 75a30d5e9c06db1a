/// @file Small dense strictly convex quadratic programs, without allocation in the loop.
#pragma once

#include <Eigen/Core>

namespace cognate::synthesis {

/// Solves  min ½ xᵀHx + gᵀx  subject to  A x + b ≥ 0, the first rows being equalities, by the dual
/// active-set method of Goldfarb and Idnani (1983, Math. Programming 27): it starts from the
/// unconstrained minimum and adds the most violated constraint at a time, so no feasible start is
/// needed.
///
/// A solver object keeps its workspace; solve() allocates only when a problem is larger than all
/// before it.
class QuadraticProgram {
 public:
  enum class Status { solved, infeasible, not_convex, iteration_limit };

  /// H: n × n, symmetric positive definite; g: n; A: m × n; b: m. On `solved`, x() is the minimum
  /// and multipliers() the m multipliers (zero where a constraint is not active, ≥ 0 but of the
  /// first `equalities` rows). Constraints count as met when violated by at most `tolerance` ·
  /// (1 + |b|).
  Status solve(const Eigen::Ref<const Eigen::MatrixXd>& hessian,
               const Eigen::Ref<const Eigen::VectorXd>& gradient,
               const Eigen::Ref<const Eigen::MatrixXd>& matrix,
               const Eigen::Ref<const Eigen::VectorXd>& offset, Eigen::Index equalities = 0,
               double tolerance = 1e-12);

  const Eigen::VectorXd& x() const { return x_; }
  const Eigen::VectorXd& multipliers() const { return multipliers_; }

 private:
  void resize(Eigen::Index n, Eigen::Index m);
  bool factor(const Eigen::Ref<const Eigen::MatrixXd>& hessian);
  bool add_constraint(Eigen::Index constraint);
  bool add_equalities(const Eigen::Ref<const Eigen::MatrixXd>& matrix,
                      const Eigen::Ref<const Eigen::VectorXd>& offset, Eigen::Index equalities,
                      double tolerance);
  void drop_constraint(Eigen::Index position);
  void step_directions(const Eigen::Ref<const Eigen::VectorXd>& normal);

  Eigen::Index active_count_ = 0;
  Eigen::MatrixXd j_;  ///< L⁻ᵀ turned so that its first columns span the active normals
  Eigen::MatrixXd r_;  ///< upper triangle: active normals in those columns
  Eigen::VectorXd d_, z_, u_step_, u_, x_, multipliers_;
  Eigen::Matrix<Eigen::Index, Eigen::Dynamic, 1> active_;
};

}  // namespace cognate::synthesis
