/// The quantile of an error over samples: its gradient by differences, its value by its definition.
#include "synthesis/robust/quantile_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "synthesis/optimise/check_derivatives.hpp"
#include "synthesis/optimise/solver.hpp"

namespace cognate::synthesis::quantile_model_test {
namespace {

/// Three points p(t) = (x₀ cos t, x₁ sin t) + x₂ (t, t²), each with a target and a parameter of its
/// own.
class PointsModel final : public Model {
 public:
  PointsModel() {
    for (int i = 0; i < 3; ++i) variables_.push_back({"x", -9, 9, 1});
    for (int i = 0; i < 3; ++i) variables_.push_back({"t", -9, 9, 1});
  }
  std::span<const Variable> variables() const override { return variables_; }
  int residual_count() const override { return 6; }
  std::span<const int> local_of_residual() const override { return locals_; }
  int local_count() const override { return 3; }
  bool residuals(std::span<const double> x, std::span<double> r, std::span<double> jacobian,
                 std::span<double> local) const override {
    for (int j = 0; j < 3; ++j) {
      const double t = x[3 + j];
      r[2 * j] = x[0] * std::cos(t) + x[2] * t - targets_[2 * j];
      r[2 * j + 1] = x[1] * std::sin(t) + x[2] * t * t - targets_[2 * j + 1];
      if (jacobian.empty()) continue;
      const double rows[]{std::cos(t), 0, t, 0, std::sin(t), t * t};
      std::copy_n(rows, 6, jacobian.begin() + 6 * j);
      local[2 * j] = -x[0] * std::sin(t) + x[2];
      local[2 * j + 1] = x[1] * std::cos(t) + 2 * x[2] * t;
    }
    return true;
  }

 private:
  std::vector<Variable> variables_;
  std::vector<int> locals_{0, 0, 1, 1, 2, 2};
  std::vector<double> targets_{2.1, 0.3, 1, 1.4, -0.4, 1.7};
};

class Shifts final : public Perturbation {
 public:
  Shifts(std::size_t count, double size) : changes_(3 * count) {
    std::mt19937 random(7);
    std::normal_distribution<double> normal(0, 1);
    for (double& change : changes_) change = size * normal(random);
  }
  std::size_t count() const override { return changes_.size() / 3; }
  void move(std::span<const double> x, std::size_t sample, std::span<double> moved,
            std::span<double> slope) const override {
    std::ranges::copy(x, moved.begin());
    std::ranges::fill(slope, 1.0);
    for (int i = 0; i < 3; ++i) moved[i] += changes_[3 * sample + i];
  }
  double at(std::size_t sample, int i) const { return changes_[3 * sample + i]; }

 private:
  std::vector<double> changes_;
};

/// The least distance of a target from the curve near t, by a fine scan and golden sections.
double distance(const std::vector<double>& x, const Shifts& shifts, std::size_t sample, int j) {
  const double targets[]{2.1, 0.3, 1, 1.4, -0.4, 1.7};
  const double a = x[0] + shifts.at(sample, 0), b = x[1] + shifts.at(sample, 1);
  const double c = x[2] + shifts.at(sample, 2);
  const auto from = [&](double t) {
    return std::hypot(a * std::cos(t) + c * t - targets[2 * j],
                      b * std::sin(t) + c * t * t - targets[2 * j + 1]);
  };
  double low = x[3 + j] - 0.4, high = x[3 + j] + 0.4;
  for (int i = 0; i < 90; ++i) {
    const double one = low + 0.381966 * (high - low), two = high - 0.381966 * (high - low);
    (from(one) < from(two) ? high : low) = from(one) < from(two) ? two : one;
  }
  return from(0.5 * (low + high));
}

/// A crank t that has no position from x + 1/2 on, as one of a linkage beyond a dead point; nearest
/// to its target at t = x, 1/10 away.
class EndingModel final : public Model {
 public:
  std::span<const Variable> variables() const override { return variables_; }
  int residual_count() const override { return 2; }
  std::span<const int> local_of_residual() const override { return locals_; }
  int local_count() const override { return 1; }
  bool residuals(std::span<const double> x, std::span<double> r, std::span<double> jacobian,
                 std::span<double> local) const override {
    if (!(x[1] < x[0] + 0.5)) return false;
    r[0] = x[1] - x[0];
    r[1] = 0.1;
    if (jacobian.empty()) return true;
    jacobian[0] = -1;
    jacobian[1] = 0;
    local[0] = 1;
    local[1] = 0;
    return true;
  }

 private:
  std::vector<Variable> variables_{{"x", -9, 9, 1}, {"t", -9, 9, 1}};
  std::vector<int> locals_{0, 0};
};

class Steps final : public Perturbation {
 public:
  std::size_t count() const override { return 9; }
  void move(std::span<const double> x, std::size_t sample, std::span<double> moved,
            std::span<double> slope) const override {
    std::ranges::copy(x, moved.begin());
    std::ranges::fill(slope, 1.0);
    moved[0] += 0.4 * (static_cast<double>(sample) - 4);
  }
};

/// What is made need not close where the design stands: the crank goes to where it does.
TEST(QuantileModel, ACrankFollowsBeyondWhereTheDesignStands) {
  const EndingModel model;
  const Steps steps;
  for (const int follow : {1, 2}) {
    const QuantileModel quantile(model, steps, {.share = 0.5, .follow = follow});
    for (const double error : quantile.errors(std::vector<double>{2, 2}, 1)) {
      EXPECT_NEAR(error, 0.1, 1e-12);
    }
  }
  // A crank that does not follow stays, and three of nine have no position there.
  const QuantileModel held(model, steps, {.share = 0.5, .follow = 0});
  const auto errors = held.errors(std::vector<double>{2, 2}, 1);
  EXPECT_EQ(std::ranges::count_if(errors, [](double e) { return std::isinf(e); }), 3);
}

const std::vector<double> kAt{2, 1.5, 0.1, 0.25, 1.1, 1.9};

TEST(QuantileModel, ErrorsAreTheGreatestLeastDistances) {
  const PointsModel model;
  const Shifts shifts(300, 0.02);
  const QuantileModel quantile(model, shifts, {.share = 0.9, .follow = 12});
  std::vector<double> brute;
  for (std::size_t k = 0; k < shifts.count(); ++k) {
    double greatest = 0;
    for (int j = 0; j < 3; ++j) greatest = std::max(greatest, distance(kAt, shifts, k, j));
    brute.push_back(greatest);
  }
  std::ranges::sort(brute);
  const auto errors = quantile.errors(kAt, 3);
  ASSERT_EQ(errors.size(), brute.size());
  for (std::size_t k = 0; k < brute.size(); ++k) EXPECT_NEAR(errors[k], brute[k], 1e-7);
  // The smoothed quantile lies among the samples about rank 270, 27 to either side.
  std::vector<double> r(1);
  ASSERT_TRUE(quantile.residuals(kAt, r, {}, {}));
  EXPECT_GT(r[0], brute[242]);
  EXPECT_LT(r[0], brute[297]);
}

TEST(QuantileModel, GradientIsThatOfDifferences) {
  const PointsModel model;
  const Shifts shifts(60, 0.05);
  const QuantileModel quantile(model, shifts,
                               {.share = 0.8, .follow = 12, .most_sum_of_squares = 3});
  std::vector<double> r(1), gradient(6), c(1), row(6), other(1);
  ASSERT_TRUE(quantile.residuals(kAt, r, gradient, {}));
  quantile.constraints(kAt, c, row);
  // So small a step that no two of sixty samples change their ranks.
  constexpr double kStep = 1e-6;
  for (std::size_t i = 0; i < 6; ++i) {
    std::vector<double> up = kAt, down = kAt;
    up[i] += kStep;
    down[i] -= kStep;
    ASSERT_TRUE(quantile.residuals(up, r, {}, {}));
    ASSERT_TRUE(quantile.residuals(down, other, {}, {}));
    EXPECT_NEAR(gradient[i], (r[0] - other[0]) / (2 * kStep), 1e-6) << i;
    quantile.constraints(up, r, {});
    quantile.constraints(down, other, {});
    EXPECT_NEAR(row[i], (r[0] - other[0]) / (2 * kStep), 1e-6) << i;
  }
}

TEST(QuantileModel, WithoutChangesItIsTheGreatestError) {
  const PointsModel model;
  const Shifts still(50, 0);
  const QuantileModel quantile(model, still, {.share = 0.99, .follow = 20});
  std::vector<double> r(1);
  ASSERT_TRUE(quantile.residuals(kAt, r, {}, {}));
  double greatest = 0;
  for (int j = 0; j < 3; ++j) greatest = std::max(greatest, distance(kAt, still, 0, j));
  EXPECT_NEAR(r[0], greatest, 1e-9);
}

TEST(QuantileModel, ADescentLowersTheQuantile) {
  const PointsModel model;
  const Shifts shifts(200, 0.05);
  const QuantileModel quantile(model, shifts, {.share = 0.95, .follow = 3});
  std::vector<double> r(1);
  ASSERT_TRUE(quantile.residuals(kAt, r, {}, {}));
  const Solution solution = solve(Solver::slsqp, quantile, kAt, {.max_iterations = 100});
  EXPECT_LT(std::sqrt(solution.objective), 0.75 * r[0]);
}

}  // namespace
}  // namespace cognate::synthesis::quantile_model_test
