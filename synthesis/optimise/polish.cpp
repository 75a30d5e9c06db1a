#include "synthesis/optimise/polish.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cassert>
#include <chrono>
#include <cmath>

#include "synthesis/optimise/dense_model.hpp"

namespace cognate::synthesis {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Damping of the first step and the least and greatest, relative to the columns of the Jacobian.
constexpr double kFirstDamping = 1e-6, kLeastDamping = 1e-16, kMostDamping = 1;
/// Residuals below are rounding, where variables and targets are of order 1.
constexpr double kRounding = 1e-16;

class Polishing {
 public:
  Polishing(const Model& model, const Options& options)
      : model_(model),
        options_(options),
        n_(model.global_count()),
        rows_(model.residual_count()),
        jacobian_(rows_, n_),
        limits_(model.constraint_count()) {
    assert(model.local_count() == 0 && model.objective() == Objective::sum_of_squares);
  }

  Solution run(std::vector<double> start) {
    at_.x = std::move(start);
    if (!evaluate(at_.x, now_, at_.violation)) return end(Stop::no_value);
    if (n_ == 0) return end(Stop::converged);
    const double most_violation = std::max(at_.violation, options_.feasibility);
    double damping = kFirstDamping;
    bool moved = true;
    for (; at_.iterations < options_.max_iterations; ++at_.iterations) {
      if (now_.lpNorm<Eigen::Infinity>() <= kRounding) return end(Stop::converged);
      if (options_.interrupted && options_.interrupted->load()) return end(Stop::interrupted);
      const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin_;
      if (spent.count() > options_.time_limit) return end(Stop::time_limit);
      if (moved && !differentiate()) return end(Stop::failed);
      std::vector<double> next = stepped(damping);
      double violation = 0;
      moved = evaluate(next, next_, violation) && violation <= most_violation &&
              next_.squaredNorm() < now_.squaredNorm();
      if (moved) {
        const bool stalled = next_.squaredNorm() > 0.99 * now_.squaredNorm();
        at_.x = std::move(next);
        at_.violation = violation;
        now_.swap(next_);
        damping = std::max(kLeastDamping, 0.1 * damping);
        stalls_ = stalled ? stalls_ + 1 : 0;
        if (stalls_ >= kMostStalls) return end(Stop::converged);
      } else if (damping >= kMostDamping) {
        return end(Stop::converged);
      } else {
        damping *= 10;
      }
    }
    return end(Stop::iteration_limit);
  }

 private:
  static constexpr int kMostStalls = 5;

  bool evaluate(const std::vector<double>& x, VectorXd& r, double& violation) {
    ++at_.evaluations;
    r.resize(rows_);
    if (!model_.residuals(x, {r.data(), std::size_t(rows_)}, {}, {}) || !r.allFinite())
      return false;
    model_.constraints(x, {limits_.data(), std::size_t(limits_.size())}, {});
    violation = largest_violation(limits_, model_.equality_count());
    return std::isfinite(violation);
  }

  bool differentiate() {
    ++at_.gradients;
    VectorXd r(rows_);
    return model_.residuals(at_.x, {r.data(), std::size_t(rows_)},
                            {jacobian_.data(), std::size_t(jacobian_.size())}, {}) &&
           jacobian_.allFinite();
  }

  /// min |J d + r|² + λ² |D d|², D the lengths of the columns of J.
  std::vector<double> stepped(double damping) const {
    RowMatrix matrix(rows_ + n_, n_);
    matrix.topRows(rows_) = jacobian_;
    matrix.bottomRows(n_) = (damping * jacobian_.colwise().norm()).asDiagonal();
    VectorXd right = VectorXd::Zero(rows_ + n_);
    right.head(rows_) = -now_;
    const VectorXd step = matrix.colPivHouseholderQr().solve(right);
    std::vector<double> next = at_.x;
    const auto variables = model_.variables();
    for (std::size_t i = 0; i < next.size(); ++i) {
      next[i] = std::clamp(next[i] + step[Index(i)], variables[i].lower, variables[i].upper);
    }
    return next;
  }

  Solution end(Stop stop) {
    at_.stop = stop;
    at_.objective = now_.squaredNorm();
    return at_;
  }

  const Model& model_;
  const Options& options_;
  const std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  Index n_, rows_;
  RowMatrix jacobian_;
  VectorXd limits_, now_, next_;
  Solution at_;
  int stalls_ = 0;
};

}  // namespace

Solution polish(const Model& model, std::vector<double> start, const Options& options) {
  return Polishing(model, options).run(std::move(start));
}

}  // namespace cognate::synthesis
