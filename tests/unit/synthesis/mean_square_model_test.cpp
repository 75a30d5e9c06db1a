/// The mean square over samples: of circles, whose distance from a point has a closed form.
#include "synthesis/robust/mean_square_model.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace cognate::synthesis::mean_square_model_test {
namespace {

constexpr double kTargets[2][2]{{3, 0.5}, {-1, 2.4}};

/// A circle (centre, radius) and, on it, a point for each target.
class CircleModel final : public Model {
 public:
  CircleModel() {
    for (const char* name : {"x", "y", "radius", "t", "t"}) variables_.push_back({name, -9, 9, 1});
  }
  std::span<const Variable> variables() const override { return variables_; }
  int residual_count() const override { return 4; }
  int constraint_count() const override { return 1; }
  std::span<const int> local_of_residual() const override { return locals_; }
  int local_count() const override { return 2; }
  bool residuals(std::span<const double> x, std::span<double> r, std::span<double> jacobian,
                 std::span<double> local) const override {
    for (int j = 0; j < 2; ++j) {
      const double c = std::cos(x[3 + j]), s = std::sin(x[3 + j]);
      r[2 * j] = x[0] + x[2] * c - kTargets[j][0];
      r[2 * j + 1] = x[1] + x[2] * s - kTargets[j][1];
      if (jacobian.empty()) continue;
      const double rows[]{1, 0, c, 0, 1, s};
      std::copy_n(rows, 6, jacobian.begin() + 6 * j);
      local[2 * j] = -x[2] * s;
      local[2 * j + 1] = x[2] * c;
    }
    return true;
  }
  void constraints(std::span<const double> x, std::span<double> c,
                   std::span<double> jacobian) const override {
    c[0] = 9 - x[2] * x[2];
    if (jacobian.empty()) return;
    jacobian[0] = jacobian[1] = 0;
    jacobian[2] = -2 * x[2];
  }

 private:
  std::vector<Variable> variables_;
  std::vector<int> locals_{0, 0, 1, 1};
};

/// Changes of centre and radius.
class Changes final : public Perturbation {
 public:
  explicit Changes(std::vector<std::vector<double>> samples) : samples_(std::move(samples)) {}
  std::size_t count() const override { return samples_.size(); }
  void move(std::span<const double> x, std::size_t sample, std::span<double> moved,
            std::span<double> slope) const override {
    std::ranges::copy(x, moved.begin());
    std::ranges::fill(slope, 1.0);
    for (int i = 0; i < 3; ++i) moved[i] += samples_[sample][i];
  }

 private:
  std::vector<std::vector<double>> samples_;
};

std::vector<double> at(double x, double y, double radius) {
  std::vector<double> all{x, y, radius};
  for (const auto& target : kTargets) all.push_back(std::atan2(target[1] - y, target[0] - x));
  return all;
}

double mean_square(const MeanSquareModel& model, const std::vector<double>& x) {
  std::vector<double> r(static_cast<std::size_t>(model.residual_count()));
  EXPECT_TRUE(model.residuals(x, r, {}, {}));
  double sum = 0;
  for (const double value : r) sum += value * value;
  return sum;
}

TEST(MeanSquareModel, PointsFollowWhereTheCircleGoes) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal(0, 0.1);
  std::vector<std::vector<double>> samples(50, std::vector<double>(3));
  for (auto& sample : samples) {
    for (double& change : sample) change = normal(random);
  }
  const CircleModel circle;
  const Changes changes(samples);
  const MeanSquareModel model(circle, changes, 20);
  double mean = 0;
  for (const auto& sample : samples) {
    for (const auto& target : kTargets) {
      const double away = std::hypot(target[0] - 0.2 - sample[0], target[1] - 0.3 - sample[1]);
      mean += std::pow(away - 2.6 - sample[2], 2) / double(samples.size());
    }
  }
  EXPECT_NEAR(mean_square(model, at(0.2, 0.3, 2.6)), mean, 1e-12);
}

TEST(MeanSquareModel, ASpreadRadiusAddsItsVariance) {
  constexpr double kSigma = 0.07;
  const CircleModel circle;
  const Changes changes({{0, 0, kSigma}, {0, 0, -kSigma}});
  const MeanSquareModel model(circle, changes, 1);
  const auto x = at(0.2, 0.3, 2.6);
  std::vector<double> r(4);
  ASSERT_TRUE(circle.residuals(x, r, {}, {}));
  const double nominal = r[0] * r[0] + r[1] * r[1] + r[2] * r[2] + r[3] * r[3];
  EXPECT_NEAR(mean_square(model, x), nominal + 2 * kSigma * kSigma, 1e-14);
}

TEST(MeanSquareModel, GradientIsThatOfDifferences) {
  const CircleModel circle;
  const Changes changes({{0.1, -0.2, 0.05}, {-0.1, 0, 0.1}, {0.04, 0.2, -0.15}});
  const MeanSquareModel model(circle, changes, 20);
  const auto x = at(0.2, 0.3, 2.6);
  const auto rows = static_cast<std::size_t>(model.residual_count());
  std::vector<double> r(rows), jacobian(rows * x.size());
  ASSERT_TRUE(model.residuals(x, r, jacobian, {}));
  for (std::size_t k = 0; k < 3; ++k) {
    constexpr double kStep = 1e-5;
    auto more = x, less = x;
    more[k] += kStep;
    less[k] -= kStep;
    double slope = 0;
    for (std::size_t row = 0; row < rows; ++row) slope += 2 * r[row] * jacobian[row * x.size() + k];
    const double difference = (mean_square(model, more) - mean_square(model, less)) / (2 * kStep);
    EXPECT_NEAR(slope, difference, 1e-8) << k;
  }
}

TEST(MeanSquareModel, LimitsAreThoseOfTheDesignItself) {
  const CircleModel circle;
  const Changes changes({{0, 0, 0.5}, {0, 0, -0.5}});
  const MeanSquareModel model(circle, changes, 1);
  std::vector<double> c(1), row(5);
  model.constraints(at(0.2, 0.3, 2.6), c, row);
  EXPECT_NEAR(c[0], 2.24, 1e-14);
  EXPECT_EQ(row, (std::vector<double>{0, 0, -5.2, 0, 0}));
}

}  // namespace
}  // namespace cognate::synthesis::mean_square_model_test
