/// @file A model as the solvers of other libraries see it: scaled, dense, counted and remembered.
#pragma once

#include <Eigen/Core>
#include <chrono>
#include <cstdint>
#include <exception>
#include <optional>
#include <span>
#include <vector>

#include "synthesis/optimise/model.hpp"
#include "synthesis/optimise/solver.hpp"
#include "synthesis/optimise/violation.hpp"

namespace cognate::synthesis {

using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// The entries of a vector or matrix in the order in which they are stored.
template <class Matrix>
std::span<double> view(Eigen::PlainObjectBase<Matrix>& m) {
  return {m.data(), static_cast<std::size_t>(m.size())};
}
template <class Matrix>
std::span<const double> view(const Eigen::PlainObjectBase<Matrix>& m) {
  return {m.data(), static_cast<std::size_t>(m.size())};
}

/// One solve of one model. Its unknowns y are the free variables (lower < upper), global and local,
/// each divided by its scale; local columns are expanded, so that every matrix is dense and every
/// derivative is with respect to y.
///
/// It counts evaluations, keeps the best point seen, watches the limits of the options, and holds
/// back what the model throws until the foreign solver has returned. Not for several threads.
class DenseModel {
 public:
  /// `start` has one entry for each variable of the model and is clamped to the bounds. The model
  /// and the options must outlive this object.
  DenseModel(const Model& model, std::span<const double> start, const Options& options);

  int size() const { return static_cast<int>(free_.size()); }
  int residual_count() const { return static_cast<int>(residuals_.size()); }
  int constraint_count() const { return static_cast<int>(constraints_.size()); }
  int equality_count() const { return equalities_; }
  bool minimax() const { return minimax_; }
  const Eigen::VectorXd& lower() const { return lower_; }
  const Eigen::VectorXd& upper() const { return upper_; }
  const Eigen::VectorXd& start() const { return start_; }

  /// Evaluates at y (of `size()`), unless that was the last point. False where the model has no
  /// finite value; the constraints are known even there.
  bool evaluate(std::span<const double> y, bool with_derivatives);

  const Eigen::VectorXd& residuals() const { return residuals_; }
  const RowMatrix& jacobian() const { return jacobian_; }
  const Eigen::VectorXd& constraints() const { return constraints_; }
  const RowMatrix& constraint_jacobian() const { return constraint_jacobian_; }
  bool has_hessian() const { return model_.has_hessian(); }
  /// The model's `lagrangian_hessian` at the last point by the unknowns; false where there is none.
  bool hessian(const Eigen::VectorXd& of_residuals, const Eigen::VectorXd& of_constraints,
               RowMatrix& out);
  /// ‖r‖² or max |r| at the last point.
  double objective() const;

  /// The best point with a value: the feasible one of least objective, else the one of least
  /// violation; the start if there was none.
  const Eigen::VectorXd& best() const { return best_; }
  double best_objective() const { return best_objective_; }
  /// The model's variables at y.
  std::vector<double> variables_at(const Eigen::VectorXd& y);

  /// Why there is nothing to solve at the start, if there is not: no value there, a limit reached,
  /// or no unknowns (which is `converged`).
  std::optional<Stop> stop_at_start();

  /// Why the solver must stop now, if it must: interruption, time, or an exception held back.
  std::optional<Stop> must_stop() const;

  /// The best point, evaluated anew. A solver's success at a point that violates the constraints
  /// becomes `infeasible`. Throws what the model threw.
  Solution finish(Stop stop, int iterations, std::vector<double> multipliers);

 private:
  using Clock = std::chrono::steady_clock;

  void expand(std::span<const double> y);
  bool call_model(bool with_derivatives);
  void gather_derivatives();
  double violation() const;
  void remember();

  const Model& model_;
  const Options& options_;
  const bool minimax_;
  const int equalities_;
  const Clock::time_point begin_ = Clock::now();
  std::vector<int> free_;  ///< the model's index of each unknown
  Eigen::VectorXd scale_, lower_, upper_, start_;

  std::vector<double> x_;  ///< all variables of the model, in its own units
  Eigen::VectorXd y_, residuals_, constraints_;
  RowMatrix jacobian_, constraint_jacobian_;
  std::vector<double> hessian_;  ///< by all variables, as the model gives it
  std::vector<double> global_, local_, constraint_global_;  ///< derivatives as the model gives them
  bool known_ = false, valid_ = false, differentiated_ = false;

  bool has_best_ = false;
  Eigen::VectorXd best_;
  double best_objective_ = 0, best_violation_ = 0;
  std::uint64_t evaluations_ = 0, gradients_ = 0;
  std::exception_ptr fault_;
};

}  // namespace cognate::synthesis
