#include "synthesis/optimise/gauss_newton.hpp"

#include <algorithm>
#include <cmath>

#include "synthesis/optimise/gauss_newton_descent.hpp"

namespace cognate::synthesis {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// What is believed of the curvature where no step has led, over that along the first step.
constexpr double kLeastCurvature = 1e-3;
/// A step is corrected that gains less than this share of what it was to gain. With half of it
/// damping would neither rise nor fall, and steps stay short for ever.
constexpr double kFallsShort = 0.9;

}  // namespace

GaussNewtonDescent::GaussNewtonDescent(const Model& model, std::span<const double> start,
                                       const Options& options)
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

bool GaussNewtonDescent::evaluate(Point& point) {
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
void GaussNewtonDescent::differentiate(const Point& point) {
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

/// Whether the model has values where the step leads, which then are those of `next_`.
bool GaussNewtonDescent::try_step() {
  next_.x.head(globals_) = now_.x.head(globals_) + scale_.head(globals_).cwiseProduct(step_.change);
  next_.x.tail(locals_) = now_.x.tail(locals_) + scale_.tail(locals_).cwiseProduct(local_step_);
  next_.x = next_.x.cwiseMax(lower_).cwiseMin(upper_);
  return evaluate(next_);
}

/// By how much the step, which is to gain `predicted`, lowers the merit from `before`; the better
/// of the step and the corrected one is taken, which then has led to `next_`. Negative where the
/// model has no value there.
double GaussNewtonDescent::gain(double before, double predicted) {
  if (!try_step()) return -1;
  const double gained = before - merit(next_);
  if (!learns_ || gained >= kFallsShort * predicted) return gained;
  uncorrected_ = step_;
  uncorrected_end_ = next_;
  if (correct_step() && before - merit(next_) > gained) return before - merit(next_);
  std::swap(step_, uncorrected_);
  std::swap(next_, uncorrected_end_);
  return gained;
}

/// From the step that led to `now_`, whose derivatives are not known yet.
void GaussNewtonDescent::learn_curvature() {
  const VectorXd before = lagrangian_gradient();
  differentiate(now_);
  const VectorXd change = lagrangian_gradient() - before;
  curvature_.learn(step_.change, change, kLeastCurvature * change.norm() / step_.change.norm());
}

/// Of the merit from `before`, by the linearised model, and by the learnt curvature.
double GaussNewtonDescent::predicted_decrease(double before) const {
  const double decrease = before - linearised_merit();
  if (!learns_) return decrease;
  const VectorXd& change = step_.change;
  return decrease - 0.5 * change.dot(curvature_.matrix() * change) / bound_weight();
}

/// What the penalties make of constraints that are missed.
double GaussNewtonDescent::penalty(const VectorXd& constraints) const {
  const Index others = limits_ - equalities_;
  return penalties_.head(equalities_).dot(constraints.head(equalities_).cwiseAbs()) +
         penalties_.tail(others).dot((-constraints.tail(others)).cwiseMax(0.0));
}

double GaussNewtonDescent::merit(const Point& point) const {
  return point.cost + penalty(point.constraints);
}

double GaussNewtonDescent::linearised_merit() const {
  VectorXd r = now_.residuals + jacobian_ * step_.change;
  for (Index row = 0; row < local_slope_.size(); ++row) {
    if (local_of_row_[row] >= 0) r[row] += local_slope_[row] * local_step_[local_of_row_[row]];
  }
  const VectorXd c = now_.constraints + constraint_jacobian_ * step_.change;
  const double cost = minimax_ ? r.lpNorm<Eigen::Infinity>() : 0.5 * r.squaredNorm();
  return cost + penalty(c);
}

void GaussNewtonDescent::raise_penalties() {
  for (Index i = 0; i < limits_; ++i) {
    penalties_[i] = std::max(penalties_[i], 2 * std::abs(step_.multipliers[i]));
  }
}

Stop GaussNewtonDescent::outside_stop() const {
  if (options_.interrupted && options_.interrupted->load(std::memory_order_relaxed)) {
    return Stop::interrupted;
  }
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin_;
  return spent.count() > options_.time_limit ? Stop::time_limit : Stop::converged;
}

Solution GaussNewtonDescent::finish(Stop stop, int iterations) const {
  if (stop == Stop::converged && now_.violation > options_.feasibility) stop = Stop::infeasible;
  Solution solution;
  solution.x.assign(now_.x.data(), now_.x.data() + now_.x.size());
  solution.objective = minimax_ ? now_.cost : 2 * now_.cost;
  solution.violation = now_.violation;
  if (limits_ > 0 && step_.multipliers.size() >= limits_) {
    // A quadratic program of least squares is that of ½|r|².
    const double unit = minimax_ ? 1 / bound_weight() : 2;
    const VectorXd multipliers = unit * step_.multipliers.head(limits_);
    solution.multipliers.assign(multipliers.data(), multipliers.data() + limits_);
  }
  solution.stop = stop;
  solution.iterations = iterations;
  solution.evaluations = evaluations_;
  solution.gradients = gradients_;
  return solution;
}

Solution GaussNewtonDescent::run() {
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
    const double predicted = predicted_decrease(before);
    const double gained = gain(before, predicted);
    const bool negligible = predicted <= options_.tolerance * before + floor;
    if (gained > 1e-4 * predicted && gained > 0) {
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

Solution solve_gauss_newton(const Model& model, std::span<const double> start,
                            const Options& options) {
  return GaussNewtonDescent(model, start, options).run();
}

}  // namespace cognate::synthesis
