/// The global searches on functions of many minima, from starts where a descent ends in a worse
/// one.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "synthesis/optimise/solver.hpp"
#include "tests/support/optimisation_problems.hpp"

namespace cognate::synthesis::testing::global_search_test {
namespace {

/// Rastrigin's function Σ x² + 10 (1 − cos 2πx) as a sum of squares: 1 − cos 2πx = 2 sin²(πx).
Values rastrigin(Point x) {
  Values out;
  for (const Complex& value : x) {
    out.push_back(value);
    out.push_back(std::sqrt(20.0) * std::sin(kPi * value));
  }
  return out;
}

FunctionModel::Parts rastrigin_parts() {
  return {boxes({{-5.12, 5.12}, {-5.12, 5.12}}), rastrigin};
}

const std::vector<double> kFarStart = {3.9, -2.9};

class GlobalSearch : public ::testing::TestWithParam<Solver> {
 protected:
  /// The best of four seeds: some of the searches find it by chance.
  Solution search(const FunctionModel::Parts& parts) const {
    Solution best;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      const Solution next = solve(GetParam(), FunctionModel(parts), kFarStart, {.seed = seed});
      if (seed == 1 || next.objective < best.objective) best = next;
    }
    return best;
  }
};

TEST_P(GlobalSearch, FindsTheLeastOfManyMinima) {
  const Solution local = solve(Solver::gauss_newton, FunctionModel(rastrigin_parts()), kFarStart);
  EXPECT_GT(local.objective, 1);
  const Solution solution = search(rastrigin_parts());
  EXPECT_EQ(solution.stop, Stop::converged);
  EXPECT_LT(solution.objective, 1e-20);
}

/// The minimum beside the origin's, at x = 0.99496 with the value 0.99496 (Törn and Žilinskas
/// 1989).
TEST_P(GlobalSearch, HonoursAnInequality) {
  FunctionModel::Parts parts = rastrigin_parts();
  parts.constraints = [](Point x) -> Values { return {x[0] - 0.5}; };
  const Solution solution = search(parts);
  EXPECT_NEAR(solution.objective, 0.99496, 1e-5);
  EXPECT_LE(solution.violation, 1e-9);
}

/// With x₂ = 2 − x₁ and x₁ = 1 + t the function is 2 + 2t² + 40 sin²(πt).
TEST_P(GlobalSearch, HonoursAnEquality) {
  FunctionModel::Parts parts = rastrigin_parts();
  parts.constraints = [](Point x) -> Values { return {x[0] + x[1] - 2.0}; };
  parts.equality_count = 1;
  const Solution solution = search(parts);
  EXPECT_NEAR(solution.objective, 2, 1e-9);
  EXPECT_LE(solution.violation, 1e-9);
}

/// All residuals vanish at the origin alone.
TEST_P(GlobalSearch, FindsTheLeastMaximum) {
  FunctionModel::Parts parts = rastrigin_parts();
  parts.objective = Objective::max_abs;
  EXPECT_LT(search(parts).objective, 1e-9);
}

/// More constraints than AGS takes by itself.
TEST_P(GlobalSearch, HonoursManyInequalities) {
  FunctionModel::Parts parts = rastrigin_parts();
  parts.constraints = [](Point x) {
    Values out(12, x[0] - 0.5);
    for (int i = 0; i < 12; ++i) out[i] += 0.01 * i;
    return out;
  };
  EXPECT_NEAR(search(parts).objective, 0.99496, 1e-5);
}

/// Freudenstein and Roth's function: a descent from its start ends at 48.98. The box is the one
/// about the start.
TEST_P(GlobalSearch, SearchesABoxWhereThereAreNoBounds) {
  const Problem problem = unconstrained_problems()[1];
  ASSERT_EQ(problem.name, "freudenstein_roth");
  const Solution solution = solve(GetParam(), problem.model, problem.starts.front(), {.seed = 1});
  EXPECT_LT(solution.objective, 1e-18);
}

/// No value within a ring about the origin, where the search would otherwise pass.
TEST_P(GlobalSearch, PassesByWhereThereIsNoValue) {
  FunctionModel::Parts parts = rastrigin_parts();
  parts.has_value = [](std::span<const double> x) {
    const double radius = std::hypot(x[0], x[1]);
    return radius < 0.8 || radius > 2.2;
  };
  const Solution solution = search(parts);
  EXPECT_LT(solution.objective, 1e-20);
}

TEST_P(GlobalSearch, RepeatsItselfWithTheSameSeed) {
  FunctionModel::Parts parts = rastrigin_parts();
  parts.constraints = [](Point x) -> Values { return {x[0] - 0.5}; };
  const FunctionModel model(parts);
  const Solution first = solve(GetParam(), model, kFarStart, {.seed = 7});
  const Solution second = solve(GetParam(), model, kFarStart, {.seed = 7});
  EXPECT_EQ(first.x, second.x);
  EXPECT_EQ(first.evaluations, second.evaluations);
}

TEST_P(GlobalSearch, KeepsToItsEvaluations) {
  std::uint64_t calls = 0;
  FunctionModel::Parts parts = rastrigin_parts();
  parts.has_value = [&](std::span<const double>) {
    ++calls;
    return true;
  };
  const Solution solution = solve(GetParam(), FunctionModel(parts), kFarStart,
                                  {.max_iterations = 10, .search_evaluations = 200});
  EXPECT_LE(solution.evaluations, calls);
  EXPECT_LE(calls, 200 + 60);  // refining takes the rest
}

INSTANTIATE_TEST_SUITE_P(Solver, GlobalSearch,
                         ::testing::Values(Solver::ags, Solver::isres, Solver::crs, Solver::mlsl,
                                           Solver::direct),
                         [](const auto& info) { return std::string(name(info.param)); });

TEST(Ags, RefusesMoreThanTenUnknowns) {
  const FunctionModel eleven({free_variables(11), rastrigin});
  EXPECT_FALSE(can_solve(Solver::ags, eleven));
  EXPECT_EQ(solve(Solver::ags, eleven, std::vector<double>(11, 1.0)).stop, Stop::failed);
  EXPECT_TRUE(can_solve(Solver::ags, FunctionModel({free_variables(10), rastrigin})));
}

}  // namespace
}  // namespace cognate::synthesis::testing::global_search_test
