/// @file What Gauss-Newton knows on its way, for its sources alone.
#pragma once

#include <Eigen/Core>
#include <chrono>
#include <cstdint>
#include <span>

#include "synthesis/optimise/dense_model.hpp"
#include "synthesis/optimise/learnt_curvature.hpp"
#include "synthesis/optimise/quadratic_program.hpp"

namespace cognate::synthesis {

/// One run of the solver.
class GaussNewtonDescent {
 public:
  GaussNewtonDescent(const Model& model, std::span<const double> start, const Options& options);
  Solution run();

 private:
  /// A point with everything known about it. Residuals are per unit, derivatives per scaled
  /// variable.
  struct Point {
    Eigen::VectorXd x, residuals, constraints;
    double cost = 0;  ///< ½|r|², or max |r|
    double violation = 0;
  };

  /// What a quadratic program says of the global variables, scaled.
  struct Step {
    Eigen::VectorXd change, multipliers;
    double bound = 0;  ///< t, of the minimax program
  };

  bool evaluate(Point& point);
  void differentiate(const Point& point);
  double largest_square() const { return globals_ > 0 ? diagonal_.maxCoeff() : 0; }
  void reduce_least_squares(double damping);
  void reduce_minimax(double damping);
  void state_constraints(double share);
  bool find_step(double damping);
  bool solve_program();
  void step_locals(double damping);
  bool try_step();
  bool correct_step();
  double gain(double before, double predicted);
  Eigen::VectorXd lagrangian_gradient() const;
  void learn_curvature();
  double bound_weight() const;
  double predicted_decrease(double before) const;
  double penalty(const Eigen::VectorXd& constraints) const;
  double merit(const Point& point) const;
  double linearised_merit() const;
  void raise_penalties();
  Stop outside_stop() const;
  Solution finish(Stop stop, int iterations) const;

  const Model& model_;
  const Options& options_;
  const std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  const bool minimax_;
  const bool learns_;  ///< the curvature of the Lagrangian
  const Eigen::Index globals_, locals_, rows_;
  const Eigen::Index limits_, equalities_;  ///< the model's constraints, and equalities in them
  std::span<const int> local_of_row_;
  Eigen::VectorXd scale_, lower_, upper_;

  Point now_, next_;
  RowMatrix jacobian_, constraint_jacobian_;
  Eigen::VectorXd local_slope_;              ///< ∂r/∂(its local variable), scaled
  Eigen::VectorXd diagonal_, local_square_;  ///< of JᵀJ
  Eigen::MatrixXd hessian_, qp_matrix_;
  Eigen::VectorXd gradient_, qp_offset_, local_rhs_;
  Eigen::MatrixXd local_rows_;  ///< Σ over the rows of a local variable of slope · row of J
  Eigen::VectorXd penalties_, local_step_;
  Step step_;
  Step uncorrected_;  ///< and where it led
  Point uncorrected_end_;
  QuadraticProgram qp_;
  QuadraticProgram::Status qp_status_ = QuadraticProgram::Status::solved;
  LearntCurvature curvature_;
  std::uint64_t evaluations_ = 0, gradients_ = 0;
};

}  // namespace cognate::synthesis
