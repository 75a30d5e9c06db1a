/// Largest residuals whose minima lie in no corner: curvature learnt from steps.
#include "synthesis/optimise/learnt_curvature.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <random>
#include <vector>

#include "synthesis/optimise/solver.hpp"
#include "tests/support/optimisation_problems.hpp"

namespace cognate::synthesis::testing::learnt_curvature_test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd random_symmetric(std::mt19937_64& random, int n) {
  std::normal_distribution<double> normal;
  const MatrixXd any = MatrixXd::NullaryExpr(n, n, [&] { return normal(random); });
  return any + any.transpose();
}

VectorXd random_step(std::mt19937_64& random, int n) {
  std::normal_distribution<double> normal;
  return VectorXd::NullaryExpr(n, [&] { return normal(random); });
}

/// Steps that are conjugate for a positive matrix (those between the points of Gram and Schmidt's
/// procedure in its metric) make it known after as many as there are unknowns.
TEST(LearntCurvature, IsThatOfAConvexQuadraticAfterConjugateSteps) {
  std::mt19937_64 random(5);
  for (int trial = 0; trial < 50; ++trial) {
    const int n = 2 + trial % 9;
    const MatrixXd root = random_symmetric(random, n);
    const MatrixXd curvature = root * root + 0.5 * root.squaredNorm() * MatrixXd::Identity(n, n);
    LearntCurvature learnt(n);
    std::vector<VectorXd> steps;
    for (int k = 0; k < n; ++k) {
      VectorXd step = random_step(random, n);
      for (const VectorXd& before : steps) {
        step -= before.dot(curvature * step) / before.dot(curvature * before) * before;
      }
      steps.push_back(step);
      learnt.learn(step, curvature * step, 1e-3);
    }
    EXPECT_LT((learnt.matrix() - curvature).norm(), 1e-9 * curvature.norm()) << n;
  }
}

/// Of any symmetric matrix, which has curvatures of both signs.
TEST(LearntCurvature, StaysPositiveAndOfTheSizeOfTheCurvature) {
  std::mt19937_64 random(7);
  for (int trial = 0; trial < 200; ++trial) {
    const int n = 2 + trial % 9;
    const MatrixXd curvature = random_symmetric(random, n);
    LearntCurvature learnt(n);
    for (int k = 0; k < 100; ++k) {
      const VectorXd step = random_step(random, n);
      learnt.learn(step, curvature * step, 1e-3 * curvature.norm());
      const VectorXd values =
          Eigen::SelfAdjointEigenSolver<MatrixXd>(learnt.matrix(), Eigen::EigenvaluesOnly)
              .eigenvalues();
      ASSERT_GT(values.minCoeff(), -1e-9 * values.maxCoeff());
      ASSERT_LT(values.maxCoeff(), 1000 * curvature.norm());
    }
  }
}

/// Rosen and Suzuki's problem as one of largest residuals (Bandler & Charalambous 1974, "Nonlinear
/// programming using minimax techniques"): of its four functions three are the largest at the
/// minimum, two fewer than unknowns and bound, so that it lies in no corner. All are raised by 200,
/// for |r|.
TEST(LearntCurvature, LeadsToMinimaWithFewLargestResiduals) {
  const auto functions = [](Point x) -> Values {
    const Complex a = x[0], b = x[1], c = x[2], d = x[3];
    const Complex f = a * a + b * b + 2.0 * c * c + d * d - 5.0 * a - 5.0 * b - 21.0 * c + 7.0 * d;
    const Complex squares = a * a + b * b + c * c + d * d;
    return {f + 200.0, f + 10.0 * (squares + a - b + c - d - 8.0) + 200.0,
            f + 10.0 * (squares + b * b + d * d - a - d - 10.0) + 200.0,
            f + 10.0 * (squares + a * a - d * d + 2.0 * a - b - d - 5.0) + 200.0};
  };
  FunctionModel::Parts parts{free_variables(4), functions};
  parts.objective = Objective::max_abs;
  const FunctionModel model(parts);
  const std::vector<double> known{0, 1, 2, -1};
  for (const std::vector<double>& start :
       {std::vector{0.0, 0.0, 0.0, 0.0}, {1.0, 2.0, 1.0, -2.0}, {-3.0, 3.0, 3.0, 3.0}}) {
    const Solution learnt =
        solve(Solver::gauss_newton, model, start,
              {.tolerance = 1e-14, .max_iterations = 60, .learns_curvature = true});
    EXPECT_NEAR(learnt.objective, 200 - 44, 1e-11);
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(learnt.x[i], known[i], 1e-5);
  }
}

/// One residual, whose derivative vanishes at the minimum: all is in the curvature.
TEST(LearntCurvature, LeadsThroughACurvedValley) {
  const auto valley = [](Point x) -> Values {
    return {1.0 + 100.0 * (x[1] - x[0] * x[0]) * (x[1] - x[0] * x[0]) +
            (1.0 - x[0]) * (1.0 - x[0])};
  };
  FunctionModel::Parts parts{free_variables(2), valley};
  parts.objective = Objective::max_abs;
  const FunctionModel model(parts);
  const Options options{.tolerance = 1e-14, .max_iterations = 60};
  Options learning = options;
  learning.learns_curvature = true;
  for (const std::vector<double>& start : {std::vector{-1.2, 1.0}, {2.0, -1.0}, {0.0, 3.0}}) {
    const Solution learnt = solve(Solver::gauss_newton, model, start, learning);
    EXPECT_NEAR(learnt.objective, 1, 1e-11);
    EXPECT_GT(solve(Solver::gauss_newton, model, start, options).objective, 1 + 1e-4);
  }
}

}  // namespace
}  // namespace cognate::synthesis::testing::learnt_curvature_test
