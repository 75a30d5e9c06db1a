/// @file The curvature of a Lagrangian, learnt from the steps of a descent.
#pragma once

#include <Eigen/Core>

namespace cognate::synthesis {

/// A positive semidefinite estimate B of second derivatives: after each step s, along which the
/// gradient changed by y, B s = y (Broyden, Fletcher, Goldfarb & Shanno 1970), or as near to it as
/// keeps B positive where the curvature along s is negative (Powell 1978, "A fast algorithm for
/// nonlinearly constrained optimization calculations"). Where no step has led B stays next to
/// nothing.
class LearntCurvature {
 public:
  explicit LearntCurvature(Eigen::Index unknowns)
      : matrix_(Eigen::MatrixXd::Zero(unknowns, unknowns)) {}

  /// `least` times the identity is what is believed before anything is known; it counts where the
  /// matrix is still zero.
  void learn(const Eigen::VectorXd& step, Eigen::VectorXd change, double least);

  const Eigen::MatrixXd& matrix() const { return matrix_; }

 private:
  Eigen::MatrixXd matrix_;
};

}  // namespace cognate::synthesis
