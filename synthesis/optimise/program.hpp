/// @file A smooth nonlinear program out of a model, for the solvers that know nothing of residuals.
#pragma once

#include <Eigen/Core>
#include <span>

#include "synthesis/optimise/dense_model.hpp"

namespace cognate::synthesis {

/// How a program states the least of max |rᵢ|.
enum class Minimax { epigraph, direct };

/// min f(z), c(z) ≥ 0 (the model's equalities first), lower ≤ z ≤ upper. A sum of squares is its
/// own program, z = y and f = ‖r‖² / unit. The least of max |rᵢ| is found by the epigraph: one
/// unknown t more,
///
///   min t  subject to  t − rᵢ/unit ≥ 0,  t + rᵢ/unit ≥ 0,
///
/// after the constraints of the model; or, for methods that need no derivatives, as it stands,
/// f = max |rᵢ| / unit. The unit is the objective at the start (1 if that is 0), so
/// that the tolerances of a solver are relative.
class Program {
 public:
  /// `model` must have a value at its start, and outlive this object.
  explicit Program(DenseModel& model, Minimax form = Minimax::epigraph);

  int size() const { return model_.size() + (epigraph_ ? 1 : 0); }
  int constraint_count() const {
    return model_.constraint_count() + (epigraph_ ? 2 * model_.residual_count() : 0);
  }
  int equality_count() const { return model_.equality_count(); }
  const Eigen::VectorXd& lower() const { return lower_; }
  const Eigen::VectorXd& upper() const { return upper_; }
  const Eigen::VectorXd& start() const { return start_; }
  double unit() const { return unit_; }
  bool epigraph() const { return epigraph_; }
  DenseModel& model() { return model_; }

  /// Makes the best point seen the start, and its objective the unit.
  void restart();

  /// Evaluates at z (of `size()`); false where the model has no value. The functions below speak of
  /// the last point, those of derivatives of the last point that was evaluated with them.
  bool evaluate(std::span<const double> z, bool with_derivatives);

  double objective() const;
  void gradient(std::span<double> out) const;
  void constraints(std::span<double> out) const;
  /// Row-major, constraint_count × size.
  void constraint_jacobian(std::span<double> out) const;

  /// Of σ f + Σ λₖ cₖ, symmetric; false where the model has none there. Wants `evaluate` with
  /// derivatives at the same point.
  bool hessian(double of_objective, std::span<const double> of_constraints, RowMatrix& out);

 private:
  DenseModel& model_;
  const bool epigraph_;
  double unit_ = 1;
  double level_ = 0;  ///< t at the last point
  Eigen::VectorXd lower_, upper_, start_;
};

}  // namespace cognate::synthesis
