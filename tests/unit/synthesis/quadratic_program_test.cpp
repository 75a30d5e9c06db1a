/// The quadratic program held against the conditions of Karush, Kuhn and Tucker, which are
/// sufficient for a strictly convex problem.
#include "synthesis/optimise/quadratic_program.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

namespace cognate::synthesis::quadratic_program_test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using Status = QuadraticProgram::Status;

MatrixXd random_matrix(std::mt19937_64& random, Eigen::Index rows, Eigen::Index columns) {
  std::normal_distribution<double> normal;
  return MatrixXd::NullaryExpr(rows, columns, [&] { return normal(random); });
}

TEST(QuadraticProgram, MeetsTheOptimalityConditions) {
  std::mt19937_64 random(1);
  QuadraticProgram program;
  int active = 0;
  for (int i = 0; i < 500; ++i) {
    const auto n = static_cast<Eigen::Index>(1 + random() % 8);
    const auto m = static_cast<Eigen::Index>(random() % 20);
    const MatrixXd root = random_matrix(random, n + 2, n);
    const MatrixXd hessian = root.transpose() * root + 1e-3 * MatrixXd::Identity(n, n);
    const VectorXd gradient = random_matrix(random, n, 1);
    const MatrixXd matrix = random_matrix(random, m, n);
    // Constraints that a planted point meets, some of them with equality.
    const VectorXd planted = random_matrix(random, n, 1);
    const VectorXd room = (random_matrix(random, m, 1).array() - 0.3).max(0.0);
    const VectorXd offset = room - matrix * planted;

    ASSERT_EQ(program.solve(hessian, gradient, matrix, offset), Status::solved) << "case " << i;
    const VectorXd& x = program.x();
    const VectorXd& multipliers = program.multipliers();
    const VectorXd slack = matrix * x + offset;
    const VectorXd stationarity = hessian * x + gradient - matrix.transpose() * multipliers;
    EXPECT_LT(stationarity.norm(), 1e-8 * (1 + multipliers.norm())) << "case " << i;
    if (m == 0) continue;
    EXPECT_GT(slack.minCoeff(), -1e-8) << "case " << i;
    EXPECT_GE(multipliers.minCoeff(), 0) << "case " << i;
    EXPECT_LT(slack.cwiseProduct(multipliers).cwiseAbs().maxCoeff(), 1e-7) << "case " << i;
    active += (multipliers.array() > 0).any();
  }
  EXPECT_GT(active, 200);
}

TEST(QuadraticProgram, KeepsEqualities) {
  int tested = 0;
  std::mt19937_64 random(2);
  QuadraticProgram program;
  for (int i = 0; i < 500; ++i) {
    const auto n = static_cast<Eigen::Index>(2 + random() % 7);
    const auto equalities = static_cast<Eigen::Index>(1 + random() % (n - 1));
    const auto m = equalities + static_cast<Eigen::Index>(random() % 12);
    const MatrixXd root = random_matrix(random, n + 2, n);
    const MatrixXd hessian = root.transpose() * root + 1e-3 * MatrixXd::Identity(n, n);
    const VectorXd gradient = random_matrix(random, n, 1);
    const MatrixXd matrix = random_matrix(random, m, n);
    const VectorXd planted = random_matrix(random, n, 1);
    VectorXd room = (random_matrix(random, m, 1).array() - 0.3).max(0.0);
    room.head(equalities).setZero();
    const VectorXd offset = room - matrix * planted;

    ASSERT_EQ(program.solve(hessian, gradient, matrix, offset, equalities), Status::solved);
    const VectorXd& x = program.x();
    const VectorXd& multipliers = program.multipliers();
    const VectorXd slack = matrix * x + offset;
    const VectorXd stationarity = hessian * x + gradient - matrix.transpose() * multipliers;
    EXPECT_LT(stationarity.norm(), 1e-8 * (1 + multipliers.norm())) << "case " << i;
    EXPECT_LT(slack.head(equalities).norm(), 1e-8) << "case " << i;
    EXPECT_GT(slack.minCoeff(), -1e-8) << "case " << i;
    if (m == equalities) continue;
    ++tested;
    EXPECT_GE(multipliers.tail(m - equalities).minCoeff(), 0) << "case " << i;
    EXPECT_LT(slack.cwiseProduct(multipliers).cwiseAbs().maxCoeff(), 1e-7) << "case " << i;
  }
  EXPECT_GE(tested, 400);
}

/// One that follows from another is left out; one that contradicts it is infeasible.
TEST(QuadraticProgram, RecognisesDependentEqualities) {
  QuadraticProgram program;
  const MatrixXd matrix{{1, 1}, {2, 2}};
  const MatrixXd hessian = MatrixXd::Identity(2, 2);
  const VectorXd gradient = VectorXd::Zero(2);
  ASSERT_EQ(program.solve(hessian, gradient, matrix, Eigen::Vector2d(-2, -4), 2), Status::solved);
  EXPECT_NEAR((program.x() - Eigen::Vector2d(1, 1)).norm(), 0, 1e-12);
  EXPECT_EQ(program.solve(hessian, gradient, matrix, Eigen::Vector2d(-2, -5), 2),
            Status::infeasible);
}

TEST(QuadraticProgram, SaysWhenConstraintsContradictEachOther) {
  QuadraticProgram program;
  MatrixXd matrix(2, 1);
  matrix << 1, -1;
  const VectorXd offset = VectorXd::Constant(2, -1.0);  // x ≥ 1 and x ≤ −1
  EXPECT_EQ(program.solve(MatrixXd::Identity(1, 1), VectorXd::Zero(1), matrix, offset),
            Status::infeasible);
}

TEST(QuadraticProgram, TakesAnEqualityAsTwoInequalities) {
  QuadraticProgram program;
  MatrixXd matrix(2, 2);
  matrix << 1, 1, -1, -1;
  VectorXd offset(2);
  offset << -1, 1;  // x + y = 1
  ASSERT_EQ(program.solve(MatrixXd::Identity(2, 2), VectorXd::Zero(2), matrix, offset),
            Status::solved);
  EXPECT_NEAR(program.x()[0], 0.5, 1e-15);
  EXPECT_NEAR(program.x()[1], 0.5, 1e-15);
}

TEST(QuadraticProgram, SaysWhenTheHessianIsNotPositiveDefinite) {
  QuadraticProgram program;
  EXPECT_EQ(
      program.solve(-MatrixXd::Identity(2, 2), VectorXd::Zero(2), MatrixXd(0, 2), VectorXd(0)),
      Status::not_convex);
}

}  // namespace
}  // namespace cognate::synthesis::quadratic_program_test
