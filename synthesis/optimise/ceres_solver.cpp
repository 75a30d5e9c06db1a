#include <ceres/cost_function.h>
#include <ceres/iteration_callback.h>
#include <ceres/problem.h>
#include <ceres/solver.h>
#include <glog/logging.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "synthesis/optimise/dense_model.hpp"
#include "synthesis/optimise/foreign_solvers.hpp"

namespace cognate::synthesis {
namespace {

using Eigen::Map;
using Eigen::VectorXd;

/// The residuals as functions of the unknowns that are not held at a bound; `y` keeps the others.
class Residuals final : public ceres::CostFunction {
 public:
  Residuals(DenseModel& model, VectorXd y, const std::vector<int>& moving)
      : model_(model), y_(std::move(y)), moving_(moving) {
    set_num_residuals(model.residual_count());
    mutable_parameter_block_sizes()->push_back(static_cast<int>(moving.size()));
  }

  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    const bool with_derivatives = jacobians && jacobians[0];
    const auto size = static_cast<Eigen::Index>(moving_.size());
    y_(moving_) = Map<const VectorXd>(parameters[0], size);
    if (!model_.evaluate(view(y_), with_derivatives)) return false;
    Map<VectorXd>(residuals, model_.residual_count()) = model_.residuals();
    if (with_derivatives) {
      Map<RowMatrix>(jacobians[0], model_.residual_count(), size) =
          model_.jacobian()(Eigen::all, moving_);
    }
    return true;
  }

 private:
  DenseModel& model_;
  mutable VectorXd y_;  ///< Ceres evaluates one point at a time here
  const std::vector<int>& moving_;
};

class Watch final : public ceres::IterationCallback {
 public:
  explicit Watch(const DenseModel& model) : model_(model) {}

  ceres::CallbackReturnType operator()(const ceres::IterationSummary&) override {
    stop_ = model_.must_stop();
    return stop_ ? ceres::SOLVER_ABORT : ceres::SOLVER_CONTINUE;
  }

  std::optional<Stop> stop() const { return stop_; }

 private:
  const DenseModel& model_;
  std::optional<Stop> stop_;
};

void silence_logging() {
  [[maybe_unused]] static const int level = FLAGS_minloglevel = google::GLOG_FATAL;
}

ceres::Solver::Options ceres_options(const Options& options, int iterations, Watch& watch) {
  ceres::Solver::Options out;
  out.linear_solver_type = ceres::DENSE_QR;
  out.max_num_iterations = iterations;
  out.function_tolerance = options.tolerance;
  out.gradient_tolerance = 1e-15;
  out.parameter_tolerance = 1e-15;
  out.num_threads = 1;
  out.logging_type = ceres::SILENT;
  out.callbacks.push_back(&watch);
  return out;
}

Stop stop_of(ceres::TerminationType type) {
  switch (type) {
    case ceres::CONVERGENCE:
      return Stop::converged;
    case ceres::NO_CONVERGENCE:
      return Stop::iteration_limit;
    default:
      return Stop::failed;
  }
}

/// An active-set method around Ceres. Ceres heeds bounds by cutting each step back to them, which
/// stalls away from the minimum where a bound is active (Rosenbrock with x₁ ≤ ½ ends 1 % above it);
/// with the unknowns at active bounds held, what is left has none.
class BoundedSearch {
 public:
  BoundedSearch(DenseModel& model, const Options& options)
      : model_(model), options_(options), y_(model.start()), held_(model.size(), false) {}

  Outcome run() {
    Stop stop = minimise();
    const bool bounded =
        model_.lower().array().isFinite().any() || model_.upper().array().isFinite().any();
    const int most_rounds = bounded ? 4 + 2 * model_.size() : 0;
    for (int round = 0; round < most_rounds && stop == Stop::converged; ++round) {
      if (!choose_held() && !meet_bound()) break;
      stop = minimise();
    }
    return {stop, iterations_, {}};
  }

 private:
  std::vector<int> moving() const {
    std::vector<int> out;
    for (int k = 0; k < model_.size(); ++k) {
      if (!held_[k]) out.push_back(k);
    }
    return out;
  }

  Stop minimise();
  bool choose_held();
  bool meet_bound();

  DenseModel& model_;
  const Options& options_;
  VectorXd y_;
  std::vector<bool> held_;
  int iterations_ = 0;
};

/// Ceres over the unknowns that are not held, from y.
Stop BoundedSearch::minimise() {
  const std::vector<int> moving = this->moving();
  if (moving.empty()) return Stop::converged;
  VectorXd z = y_(moving);
  Residuals residuals(model_, y_, moving);
  ceres::Problem::Options ownership;
  ownership.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem problem(ownership);
  problem.AddResidualBlock(&residuals, nullptr, z.data());
  for (int i = 0; i < z.size(); ++i) {
    const double lower = model_.lower()[moving[i]], upper = model_.upper()[moving[i]];
    if (std::isfinite(lower)) problem.SetParameterLowerBound(z.data(), i, lower);
    if (std::isfinite(upper)) problem.SetParameterUpperBound(z.data(), i, upper);
  }
  Watch watch(model_);
  ceres::Solver::Summary summary;
  ceres::Solve(ceres_options(options_, options_.max_iterations - iterations_, watch), &problem,
               &summary);
  y_(moving) = z;
  iterations_ += summary.num_successful_steps + summary.num_unsuccessful_steps;
  return watch.stop().value_or(stop_of(summary.termination_type));
}

/// Holds exactly the unknowns at a bound that the gradient presses against it; whether that is a
/// change.
bool BoundedSearch::choose_held() {
  if (!model_.evaluate(view(y_), true)) return false;
  const VectorXd gradient = model_.jacobian().transpose() * model_.residuals();
  std::vector<bool> held(model_.size());
  for (int k = 0; k < model_.size(); ++k) {
    held[k] = (y_[k] <= model_.lower()[k] && gradient[k] > 0) ||
              (y_[k] >= model_.upper()[k] && gradient[k] < 0);
  }
  return std::exchange(held_, held) != held;
}

/// Where the Gauss-Newton step of the moving unknowns would cross a bound, goes as far as the first
/// one and holds it there; whether that lowers the objective.
bool BoundedSearch::meet_bound() {
  const std::vector<int> moving = this->moving();
  const RowMatrix jacobian = model_.jacobian()(Eigen::all, moving);
  const VectorXd step =
      -(jacobian.transpose() * jacobian).ldlt().solve(jacobian.transpose() * model_.residuals());
  double share = 1;
  int first = -1;
  for (int i = 0; i < step.size(); ++i) {
    const int k = moving[i];
    const double room = (step[i] > 0 ? model_.upper()[k] : model_.lower()[k]) - y_[k];
    if (std::abs(room) < share * std::abs(step[i])) {
      share = room / step[i];
      first = i;
    }
  }
  if (first < 0) return false;
  const double before = model_.objective();
  VectorXd met = y_;
  met(moving) += share * step;
  const int k = moving[first];
  met[k] = step[first] > 0 ? model_.upper()[k] : model_.lower()[k];
  met = met.cwiseMax(model_.lower()).cwiseMin(model_.upper());
  if (!model_.evaluate(view(met), false) || model_.objective() >= before) return false;
  y_ = met;
  held_[k] = true;
  return true;
}

}  // namespace

Outcome minimise_with_ceres(DenseModel& model, const Options& options) {
  silence_logging();
  return BoundedSearch(model, options).run();
}

}  // namespace cognate::synthesis
