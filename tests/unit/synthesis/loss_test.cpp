/// Robust losses: their values are Ceres' own, and a gross error in the target does not govern the
/// design.
#include "synthesis/optimise/loss.hpp"

#include <ceres/loss_function.h>
#include <ceres/problem.h>
#include <ceres/sized_cost_function.h>
#include <ceres/solver.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "analysis/linkage/motion.hpp"
#include "problems/basics/names.hpp"
#include "problems/linkage/result.hpp"
#include "synthesis/optimise/check_derivatives.hpp"
#include "synthesis/optimise/solver.hpp"
#include "tests/support/optimisation_problems.hpp"

namespace cognate::loss_test {
namespace {

using synthesis::Loss;

constexpr Loss kAll[] = {Loss::huber, Loss::soft_l1, Loss::cauchy, Loss::arctan, Loss::tukey};

std::unique_ptr<ceres::LossFunction> of_ceres(Loss loss) {
  switch (loss) {
    case Loss::none:
      break;
    case Loss::huber:
      return std::make_unique<ceres::HuberLoss>(1);
    case Loss::soft_l1:
      return std::make_unique<ceres::SoftLOneLoss>(1);
    case Loss::cauchy:
      return std::make_unique<ceres::CauchyLoss>(1);
    case Loss::arctan:
      return std::make_unique<ceres::ArctanLoss>(1);
    case Loss::tukey:
      return std::make_unique<ceres::TukeyLoss>(1);
  }
  return std::make_unique<ceres::TrivialLoss>();
}

TEST(Loss, IsThatOfCeres) {
  for (const auto& [name, loss] : problems::names<Loss>()) {
    SCOPED_TRACE(name);
    for (const double s : {0.0, 1e-6, 0.3, 0.99, 1.01, 4.0, 1e6}) {
      double expected[3];
      of_ceres(loss)->Evaluate(s, expected);
      const auto [value, slope] = evaluate(loss, s);
      EXPECT_NEAR(value, expected[0], 1e-14 * (1 + s)) << "at " << s;
      EXPECT_NEAR(slope, expected[1], 1e-14) << "at " << s;
    }
  }
}

/// One residual, x itself.
class Identity final : public synthesis::Model {
 public:
  std::span<const synthesis::Variable> variables() const override { return {&x_, 1}; }
  int residual_count() const override { return 1; }
  bool residuals(std::span<const double> x, std::span<double> r, std::span<double> jacobian,
                 std::span<double>) const override {
    r[0] = x[0];
    if (!jacobian.empty()) jacobian[0] = 1;
    return true;
  }

 private:
  synthesis::Variable x_{"x", -1e200, 1e200, 1};
};

/// Far below the scale all losses are least squares, far beyond they have finite slopes.
TEST(RobustModel, IsFiniteAtAnyScale) {
  int tested = 0;
  const Identity model;
  for (const Loss loss : kAll) {
    for (const double scale : {1e-150, 1e-80, 1e80, 1e150}) {
      const synthesis::RobustModel robust(model, loss, scale, 1);
      const double x = 2;
      double r = 0, slope = 0;
      ASSERT_TRUE(robust.residuals({&x, 1}, {&r, 1}, {&slope, 1}, {}));
      EXPECT_TRUE(std::isfinite(r) && std::isfinite(slope)) << scale;
      if (scale < 1) continue;
      ++tested;
      EXPECT_EQ(r, x);
      EXPECT_NEAR(slope, 1, 1e-15);
    }
  }
  EXPECT_GE(tested, 10);
}

TEST(RobustModel, HasRightDerivatives) {
  for (const synthesis::testing::Problem& problem : synthesis::testing::local_problems()) {
    for (const Loss loss : kAll) {
      const synthesis::RobustModel robust(problem.model, loss, 0.4, 2);
      const auto error = check_derivatives(robust, problem.starts.front());
      EXPECT_TRUE(error.has_value);
      EXPECT_LT(error.relative, 1e-7) << problem.name << ": " << error.describe(robust);
    }
  }
}

/// y = a + bt at t = 0, 1, … with one gross error.
const std::vector<double> kLine = {1.02, 2.97, 5.05, 6.96, 9.01, 50, 13.03};

class LineError final : public ceres::SizedCostFunction<1, 2> {
 public:
  explicit LineError(std::size_t i) : t_(double(i)), y_(kLine[i]) {}
  bool Evaluate(double const* const* x, double* r, double** jacobian) const override {
    r[0] = x[0][0] + x[0][1] * t_ - y_;
    if (jacobian && jacobian[0]) jacobian[0][0] = 1, jacobian[0][1] = t_;
    return true;
  }

 private:
  double t_, y_;
};

/// Ceres with its own loss functions ends at the same line.
TEST(RobustModel, HasTheMinimumOfCeres) {
  const synthesis::testing::FunctionModel line(
      {synthesis::testing::free_variables(2), [](synthesis::testing::Point x) {
         synthesis::testing::Values out;
         for (std::size_t i = 0; i < kLine.size(); ++i) {
           out.push_back(x[0] + x[1] * double(i) - kLine[i]);
         }
         return out;
       }});
  for (const Loss loss : {Loss::huber, Loss::soft_l1, Loss::cauchy}) {
    double expected[] = {1, 2};
    ceres::Problem problem;
    for (std::size_t i = 0; i < kLine.size(); ++i) {
      problem.AddResidualBlock(new LineError(i), of_ceres(loss).release(), expected);
    }
    ceres::Solver::Options options;
    options.logging_type = ceres::SILENT;
    options.function_tolerance = 1e-15;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);

    const synthesis::RobustModel robust(line, loss, 1, 1);
    for (const auto solver : {synthesis::Solver::gauss_newton, synthesis::Solver::ceres,
                              synthesis::Solver::slsqp, synthesis::Solver::crs}) {
      const auto solution = solve(solver, robust, std::vector{1.0, 2.0});
      EXPECT_NEAR(solution.objective, 2 * summary.final_cost, 1e-9);
      EXPECT_NEAR(solution.x[0], expected[0], 1e-5);
      EXPECT_NEAR(solution.x[1], expected[1], 1e-5);
    }
  }
}

/// Distance of the first design from the points that it should meet, all but `spoilt`.
double miss(const problems::Result& result, const std::vector<Vec2d>& points, std::size_t spoilt) {
  if (result.designs.empty()) return std::numeric_limits<double>::infinity();
  const problems::Design& design = result.designs.front();
  const Motion motion(*design.mechanism.four_bar());
  double largest = 0;
  for (std::size_t j = 0; j < points.size(); ++j) {
    if (j == spoilt) continue;
    const auto at = motion.at(design.crank_angles[j]);
    largest = std::max(largest, std::sqrt(squared_norm(*at->coupler_point - points[j])));
  }
  return largest;
}

TEST(PathGeneration, PassesByAGrossError) {
  const FourBar planted{{0.2, -0.3}, {2.1, 0.9}, 0.8, 1.9, 1.6, Assembly::open, Vec2d{1.1, 0.7}};
  problems::PathProblem problem;
  problem.timing = problems::Timing::prescribed;
  problem.crank_reference = problems::CrankReference::global;
  for (int j = 0; j < 14; ++j) {
    problem.crank_angles.push_back(0.3 + 0.4 * j);
    problem.points.push_back(*Motion(planted).at(problem.crank_angles.back())->coupler_point);
  }
  problem.weights.assign(problem.points.size(), 1);
  const std::vector<Vec2d> right = problem.points;
  constexpr std::size_t kSpoilt = 5;
  problem.points[kSpoilt] = problem.points[kSpoilt] + Vec2d{0.5, -0.4};
  problem.solve.designs = 1;
  problem.solve.starts = 40;
  EXPECT_GT(miss(solve(problem, {}), right, kSpoilt), 0.01);
  problem.solve.loss_scale = 1e-3;
  for (const Loss loss : kAll) {
    problem.solve.loss = loss;
    // Losses that go on growing leave a pull, of the size of the scale.
    const double allowed = loss == Loss::tukey ? 1e-9 : 2e-3;
    EXPECT_LT(miss(solve(problem, {}), right, kSpoilt), allowed) << problems::to_string(loss);
  }
}

TEST(FunctionGeneration, PassesByAGrossError) {
  const FourBar planted{{0, 0}, {2.2, 0}, 1, 1.9, 1.6, Assembly::open, {}};
  const double input_start = 0.6;
  const auto rocker_angle = [&](double input) {
    const Vec2d c = Motion(planted).at(input)->c;
    return std::atan2(c.y - planted.pivot_d.y, c.x - planted.pivot_d.x);
  };
  problems::FunctionProblem problem;
  problems::AnglePairs pairs;
  for (int i = 0; i < 12; ++i) {
    const double input = 0.12 * i;
    pairs.emplace_back(input, rocker_angle(input_start + input) - rocker_angle(input_start));
  }
  const problems::AnglePairs right = pairs;
  constexpr std::size_t kSpoilt = 7;
  pairs[kSpoilt].second += 0.2;
  problem.given.crank = 1;
  problem.solve.designs = 1;
  problem.solve.starts = 40;
  const auto miss_of = [&] {
    problem.target = pairs;
    const auto result = solve(problem, {});
    if (result.designs.empty()) return std::numeric_limits<double>::infinity();
    // The sum of squares is that of the spoilt pair alone where all others are met.
    const double spoilt = result.designs.front().error.max;
    return std::sqrt(std::abs(result.designs.front().error.sum_of_squares - spoilt * spoilt));
  };
  EXPECT_GT(miss_of(), 0.01);
  problem.solve.loss_scale = 1e-3;
  for (const Loss loss : kAll) {
    problem.solve.loss = loss;
    EXPECT_LT(miss_of(), loss == Loss::tukey ? 1e-6 : 3e-3) << problems::to_string(loss);
  }
}

}  // namespace
}  // namespace cognate::loss_test
