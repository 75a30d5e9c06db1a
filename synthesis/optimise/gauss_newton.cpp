#include "synthesis/optimise/gauss_newton.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "synthesis/optimise/dense_model.hpp"
#include "synthesis/optimise/learnt_curvature.hpp"
#include "synthesis/optimise/quadratic_program.hpp"

namespace cognate::synthesis {
namespace {

using Clock = std::chrono::steady_clock;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// What is believed of the curvature where no step has led, over that along the first step.
constexpr double kLeastCurvature = 1e-3;
/// A step is corrected that gains less than this share of what it was to gain. With half of it
/// damping would neither rise nor fall, and steps stay short for ever.
constexpr double kFallsShort = 0.9;

/// A point with everything known about it. Residuals are per unit, derivatives per scaled variable.
struct Point {
  VectorXd x, residuals, constraints;
  double cost = 0;  ///< ½|r|², or max |r|
  double violation = 0;
};

class GaussNewton {
 public:
  GaussNewton(const Model& model, std::span<const double> start, const Options& options);
  Solution run();

 private:
  bool evaluate(Point& point);
  void differentiate(const Point& point);
  void reduce_least_squares(double damping);
  void reduce_minimax(double damping);
  void state_constraints(double share);
  bool find_step(double damping);
  void step_locals(double damping);
  bool try_step();
  bool correct_step();
  VectorXd lagrangian_gradient() const;
  void learn_curvature();
  double bound_weight() const;
  double curvature_of_step() const;
  double penalty(const VectorXd& constraints) const;
  double merit(const Point& point) const;
  double linearised_merit() const;
  void raise_penalties();
  Stop outside_stop() const;
  Solution finish(Stop stop, int iterations) const;

  const Model& model_;
  const Options& options_;
  const Clock::time_point begin_ = Clock::now();
  const bool minimax_;
  const bool learns_;  ///< the curvature of the Lagrangian
  const Index globals_, locals_, rows_;
  const Index limits_, equalities_;  ///< numbers of the model's constraints, of equalities in them
  std::span<const int> local_of_row_;
  VectorXd scale_, lower_, upper_;

  Point now_, next_;
  RowMatrix jacobian_, constraint_jacobian_;
  VectorXd local_slope_;              ///< ∂r/∂(its local variable), scaled
  VectorXd diagonal_, local_square_;  ///< of JᵀJ
  double largest_square() const { return globals_ > 0 ? diagonal_.maxCoeff() : 0; }
  MatrixXd hessian_, qp_matrix_;
  VectorXd gradient_, qp_offset_, local_rhs_;
  MatrixXd local_rows_;  ///< Σ over the rows of a local variable of slope · row of J
  VectorXd penalties_, step_, local_step_, model_residuals_;
  QuadraticProgram qp_;
  LearntCurvature curvature_;
  std::uint64_t evaluations_ = 0, gradients_ = 0;
};

GaussNewton::GaussNewton(const Model& model, std::span<const double> start, const Options& options)
    : model_(model),
      options_(options),
      minimax_(model.objective() == Objective::max_abs),
      learns_(minimax_ && options.learns_curvature && model.local_count() == 0),
      globals_(model.global_count()),
      locals_(model.local_count()),
      rows_(model.residual_count()),
      limits_(model.constraint_count()),
      equalities_(model.equality_count()),
      local_of_row_(model.local_of_residual()),
      curvature_(learns_ ? globals_ : 0) {
  const auto variables = model.variables();
  const auto n = static_cast<Index>(variables.size());
  scale_.resize(n);
  lower_.resize(n);
  upper_.resize(n);
  now_.x.resize(n);
  for (Index i = 0; i < n; ++i) {
    const Variable& v = variables[i];
    scale_[i] = v.scale;
    lower_[i] = v.lower;
    upper_[i] = v.upper;
    now_.x[i] = std::clamp(start[i], v.lower, v.upper);
  }
  now_.residuals.resize(rows_);
  now_.constraints.resize(limits_);
  next_ = now_;
  jacobian_.resize(rows_, globals_);
  constraint_jacobian_.resize(limits_, globals_);
  local_slope_.resize(locals_ > 0 ? rows_ : 0);
  local_square_.resize(locals_);
  local_rhs_.resize(locals_);
  local_rows_.resize(locals_, globals_);
  local_step_.setZero(locals_);
  penalties_.setZero(limits_);
  if (std::ssize(options.multipliers) == limits_) {
    for (Index i = 0; i < limits_; ++i) penalties_[i] = std::abs(options.multipliers[i]);
  }
  diagonal_.setZero(globals_);
}

bool GaussNewton::evaluate(Point& point) {
  ++evaluations_;
  if (!model_.residuals(view(point.x), view(point.residuals), {}, {})) return false;
  if (!point.residuals.allFinite()) return false;
  model_.constraints(view(point.x), view(point.constraints), {});
  if (!point.constraints.allFinite()) return false;
  point.cost =
      minimax_ ? point.residuals.lpNorm<Eigen::Infinity>() : 0.5 * point.residuals.squaredNorm();
  point.violation = largest_violation(point.constraints, static_cast<int>(equalities_));
  return true;
}

/// Fills the Jacobians at `point`, per scaled variable; `next_` serves as scratch.
void GaussNewton::differentiate(const Point& point) {
  ++gradients_;
  model_.residuals(view(point.x), view(next_.residuals), view(jacobian_), view(local_slope_));
  jacobian_ *= scale_.head(globals_).asDiagonal();
  if (limits_ > 0) {
    model_.constraints(view(point.x), view(next_.constraints), view(constraint_jacobian_));
    constraint_jacobian_ *= scale_.head(globals_).asDiagonal();
  }
  for (Index row = 0; row < local_slope_.size(); ++row) {
    if (local_of_row_[row] >= 0) local_slope_[row] *= scale_[globals_ + local_of_row_[row]];
  }
  diagonal_ = diagonal_.cwiseMax(jacobian_.colwise().squaredNorm().transpose());
}

/// The normal equations of the damped step with the local variables eliminated.
void GaussNewton::reduce_least_squares(double damping) {
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
void GaussNewton::reduce_minimax(double damping) {
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
void GaussNewton::state_constraints(double share) {
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

bool GaussNewton::find_step(double damping) {
  if (minimax_) {
    reduce_minimax(damping);
  } else {
    reduce_least_squares(damping);
  }
  for (const double share : {1.0, 0.5, 0.1, 0.0}) {
    state_constraints(share);
    const auto status = qp_.solve(hessian_, gradient_, qp_matrix_, qp_offset_, equalities_);
    if (status == QuadraticProgram::Status::solved) {
      step_ = qp_.x().head(globals_);
      step_locals(damping);
      return step_.allFinite();
    }
    if (status == QuadraticProgram::Status::not_convex || limits_ == 0) return false;
  }
  return false;
}

/// Whether the model has values where the step leads, which then are those of `next_`.
bool GaussNewton::try_step() {
  next_.x.head(globals_) = now_.x.head(globals_) + scale_.head(globals_).cwiseProduct(step_);
  next_.x.tail(locals_) = now_.x.tail(locals_) + scale_.tail(locals_).cwiseProduct(local_step_);
  next_.x = next_.x.cwiseMax(lower_).cwiseMin(upper_);
  return evaluate(next_);
}

/// The step of the same quadratic program with the values at `next_`, where the last step led, less
/// what that step was to change of them: a second-order correction (Fletcher 1982, "Second order
/// corrections for non-differentiable optimization").
bool GaussNewton::correct_step() {
  qp_offset_.head(limits_) = next_.constraints - constraint_jacobian_ * step_;
  const VectorXd residuals = next_.residuals - jacobian_ * step_;
  Index row = qp_offset_.size() - 2 * rows_;
  for (const double residual : residuals) {
    qp_offset_[row++] = residual;
    qp_offset_[row++] = -residual;
  }
  const auto status = qp_.solve(hessian_, gradient_, qp_matrix_, qp_offset_, equalities_);
  if (status != QuadraticProgram::Status::solved) return false;
  step_ = qp_.x().head(globals_);
  return step_.allFinite();
}

/// Of the Lagrangian at `now_` with the multipliers of the last quadratic program.
VectorXd GaussNewton::lagrangian_gradient() const {
  const VectorXd& multipliers = qp_.multipliers();
  VectorXd of_residuals(rows_);
  Index row = multipliers.size() - 2 * rows_;
  for (double& factor : of_residuals) {
    factor = multipliers[row + 1] - multipliers[row];
    row += 2;
  }
  return jacobian_.transpose() * of_residuals -
         constraint_jacobian_.transpose() * multipliers.head(limits_);
}

/// From the step that led to `now_`, whose derivatives are not known yet.
void GaussNewton::learn_curvature() {
  const VectorXd before = lagrangian_gradient();
  differentiate(now_);
  const VectorXd change = lagrangian_gradient() - before;
  curvature_.learn(step_, change, kLeastCurvature * change.norm() / step_.norm());
}

/// The slope of the minimax quadratic program's t + t²/2m at its solution: its multipliers are
/// those of the problem times this.
double GaussNewton::bound_weight() const {
  return 1 + hessian_(globals_, globals_) * qp_.x()[globals_];
}

/// What the learnt curvature takes from the decrease that a step has to the first order.
double GaussNewton::curvature_of_step() const {
  return learns_ ? 0.5 * step_.dot(curvature_.matrix() * step_) / bound_weight() : 0;
}

void GaussNewton::step_locals(double damping) {
  for (Index local = 0; local < locals_; ++local) {
    const double along = local_rhs_[local] + local_rows_.row(local).dot(step_);
    local_step_[local] = -along / (local_square_[local] * (1 + damping) + 1e-300);
  }
}

/// What the penalties make of constraints that are missed.
double GaussNewton::penalty(const VectorXd& constraints) const {
  const Index others = limits_ - equalities_;
  return penalties_.head(equalities_).dot(constraints.head(equalities_).cwiseAbs()) +
         penalties_.tail(others).dot((-constraints.tail(others)).cwiseMax(0.0));
}

double GaussNewton::merit(const Point& point) const {
  return point.cost + penalty(point.constraints);
}

double GaussNewton::linearised_merit() const {
  VectorXd r = now_.residuals + jacobian_ * step_;
  for (Index row = 0; row < local_slope_.size(); ++row) {
    if (local_of_row_[row] >= 0) r[row] += local_slope_[row] * local_step_[local_of_row_[row]];
  }
  const VectorXd c = now_.constraints + constraint_jacobian_ * step_;
  const double cost = minimax_ ? r.lpNorm<Eigen::Infinity>() : 0.5 * r.squaredNorm();
  return cost + penalty(c);
}

void GaussNewton::raise_penalties() {
  for (Index i = 0; i < limits_; ++i) {
    penalties_[i] = std::max(penalties_[i], 2 * std::abs(qp_.multipliers()[i]));
  }
}

Stop GaussNewton::outside_stop() const {
  if (options_.interrupted && options_.interrupted->load(std::memory_order_relaxed)) {
    return Stop::interrupted;
  }
  const std::chrono::duration<double> spent = Clock::now() - begin_;
  return spent.count() > options_.time_limit ? Stop::time_limit : Stop::converged;
}

Solution GaussNewton::finish(Stop stop, int iterations) const {
  if (stop == Stop::converged && now_.violation > options_.feasibility) stop = Stop::infeasible;
  Solution solution;
  solution.x.assign(now_.x.data(), now_.x.data() + now_.x.size());
  solution.objective = minimax_ ? now_.cost : 2 * now_.cost;
  solution.violation = now_.violation;
  if (limits_ > 0 && qp_.multipliers().size() >= limits_) {
    // A quadratic program of least squares is that of ½|r|².
    const double unit = minimax_ ? 1 / bound_weight() : 2;
    const VectorXd multipliers = unit * qp_.multipliers().head(limits_);
    solution.multipliers.assign(multipliers.data(), multipliers.data() + limits_);
  }
  solution.stop = stop;
  solution.iterations = iterations;
  solution.evaluations = evaluations_;
  solution.gradients = gradients_;
  return solution;
}

Solution GaussNewton::run() {
  if (!evaluate(now_)) return finish(Stop::no_value, 0);
  if (globals_ + locals_ == 0) return finish(Stop::converged, 0);
  const double floor = 1e-32 * (1 + now_.cost);
  double damping = 1e-3, growth = 2;
  bool moved = true;
  int stalled = 0;
  for (int iteration = 0; iteration < options_.max_iterations; ++iteration) {
    if (const Stop stop = outside_stop(); stop != Stop::converged) return finish(stop, iteration);
    if (moved && learns_ && iteration > 0) {
      learn_curvature();
    } else if (moved) {
      differentiate(now_);
    }
    moved = false;
    if (!find_step(damping)) {
      if (damping > 1e12) return finish(Stop::failed, iteration);
      damping = std::max(10 * damping, 1e-8);
      continue;
    }
    raise_penalties();
    const double before = merit(now_);
    const double predicted = before - linearised_merit() - curvature_of_step();
    bool valid = try_step();
    double gained = valid ? before - merit(next_) : 0;
    const bool falls_short = valid && gained < kFallsShort * predicted;
    if (learns_ && falls_short && correct_step()) {
      valid = try_step();
      gained = valid ? before - merit(next_) : 0;
    }
    const bool negligible = predicted <= options_.tolerance * before + floor;
    if (valid && gained > 1e-4 * predicted && gained > 0) {
      const double ratio = gained / predicted;
      damping = std::max(damping * std::max(1.0 / 3, 1 - std::pow(2 * ratio - 1, 3)), 1e-15);
      growth = 2;
      std::swap(now_, next_);
      moved = true;
      stalled = gained <= options_.tolerance * before ? stalled + 1 : 0;
      if (now_.violation <= options_.feasibility && (stalled >= 2 || now_.cost <= floor)) {
        return finish(Stop::converged, iteration + 1);
      }
    } else {
      if (negligible || damping > 1e12) return finish(Stop::converged, iteration + 1);
      damping *= growth;
      growth *= 2;
    }
  }
  return finish(Stop::iteration_limit, options_.max_iterations);
}

}  // namespace

Solution solve_gauss_newton(const Model& model, std::span<const double> start,
                            const Options& options) {
  return GaussNewton(model, start, options).run();
}

}  // namespace cognate::synthesis
