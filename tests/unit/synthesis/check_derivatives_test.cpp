#include "synthesis/optimise/check_derivatives.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/optimisation_problems.hpp"

namespace cognate::synthesis::testing::check_derivatives_test {
namespace {

/// Complex steps are exact: what is left is the doubt of the differences.
TEST(CheckDerivatives, AgreesWithComplexSteps) {
  for (const Problem& problem : all_problems()) {
    for (const std::vector<double>& start : problem.starts) {
      const DerivativeError error = check_derivatives(problem.model, start);
      EXPECT_TRUE(error.has_value);
      EXPECT_LE(error.relative, 1e-8) << problem.name << ": " << error.describe(problem.model);
    }
  }
}

/// A model with one derivative falsified by one part in a thousand.
class Falsified final : public Model {
 public:
  enum class Where { jacobian, local, constraint };
  Falsified(const Model& model, Where where) : model_(model), where_(where) {}

  std::span<const Variable> variables() const override { return model_.variables(); }
  int residual_count() const override { return model_.residual_count(); }
  int constraint_count() const override { return model_.constraint_count(); }
  std::span<const int> local_of_residual() const override { return model_.local_of_residual(); }
  int local_count() const override { return model_.local_count(); }
  bool residuals(std::span<const double> x, std::span<double> r, std::span<double> jacobian,
                 std::span<double> local) const override {
    const bool has_value = model_.residuals(x, r, jacobian, local);
    if (where_ == Where::jacobian && !jacobian.empty()) jacobian[0] *= 1.001;
    if (where_ == Where::local && !local.empty()) local[5] *= 1.001;
    return has_value;
  }
  void constraints(std::span<const double> x, std::span<double> c,
                   std::span<double> jacobian) const override {
    model_.constraints(x, c, jacobian);
    if (where_ == Where::constraint && !jacobian.empty()) jacobian[3] *= 1.001;
  }

 private:
  const Model& model_;
  Where where_;
};

TEST(CheckDerivatives, FindsAWrongGlobalColumn) {
  const Problem problem = unconstrained_problems().front();
  const Falsified model(problem.model, Falsified::Where::jacobian);
  const DerivativeError error = check_derivatives(model, std::vector{-1.2, 1.0});
  EXPECT_NEAR(error.relative, 1e-3, 1e-6);
  EXPECT_EQ(error.row, 0);
  EXPECT_EQ(error.variable, 0);
}

TEST(CheckDerivatives, FindsAWrongLocalColumn) {
  const Problem problem = local_problems().front();
  const Falsified model(problem.model, Falsified::Where::local);
  const DerivativeError error = check_derivatives(model, problem.starts.front());
  EXPECT_GT(error.relative, 1e-5);
  EXPECT_EQ(error.part, DerivativeError::Part::residuals);
  EXPECT_EQ(error.row, 5);
  EXPECT_EQ(error.variable, 3 + 2);
}

TEST(CheckDerivatives, FindsAWrongConstraint) {
  const Problem problem = constrained_problems()[1];
  const Falsified model(problem.model, Falsified::Where::constraint);
  const DerivativeError error = check_derivatives(model, std::vector{1.0, 2.0, -1.0, 3.0});
  EXPECT_EQ(error.part, DerivativeError::Part::constraints);
  EXPECT_EQ(error.row, 0);
  EXPECT_EQ(error.variable, 3);
}

TEST(CheckDerivatives, SaysWhereThereIsNoValue) {
  const Problem problem = bounded_problems().back();
  EXPECT_FALSE(check_derivatives(problem.model, std::vector{-1.0}).has_value);
}

}  // namespace
}  // namespace cognate::synthesis::testing::check_derivatives_test
