#include "synthesis/optimise/solver.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <thread>
#include <vector>

#include "tests/support/optimisation_problems.hpp"

namespace cognate::synthesis::testing::solver_test {
namespace {

/// Each but `automatic`, which is one of the others.
std::vector<Solver> all_solvers() {
  std::vector<Solver> all;
  for (const SolverDeclaration& solver : kSolvers) {
    if (solver.id != Solver::automatic) all.push_back(solver.id);
  }
  return all;
}

/// Evaluations of a global search where only what refines its best point matters.
constexpr std::uint64_t kShortSearch = 300;

/// Models that are not those of Newton creep along a curved valley, sometimes beyond any limit.
bool creeps(Solver solver) {
  return solver == Solver::mma || solver == Solver::ccsaq || solver == Solver::cobyla ||
         solver == Solver::bobyqa;
}

/// What each solver is good for, measured on these problems and rounded up.
struct Accuracy {
  double objective;  ///< relative to the minimum
  double zero;       ///< ‖r‖² where the minimum is 0, relative to the start
  double point;      ///< of x, per scale; 0: not looked at
  int iterations;    ///< that it may need
};

Accuracy accuracy(Solver solver, const Problem& problem) {
  const bool minimax = problem.model.objective() == Objective::max_abs;
  switch (solver) {
    case Solver::automatic:
    case Solver::gauss_newton:
      // Its minimax iteration ends at about half the digits.
      return minimax ? Accuracy{1e-10, 0, 1e-5, 200} : Accuracy{1e-9, 1e-26, 3e-6, 400};
    case Solver::ceres:
      return {1e-9, 1e-22, 3e-6, 200};
    case Solver::ags:
    case Solver::isres:
    case Solver::crs:
    case Solver::mlsl:
    case Solver::direct:
      // They may end whole turns away.
      return minimax ? Accuracy{1e-9, 1e-22, 0, 400} : Accuracy{1e-9, 1e-26, 0, 400};
    case Solver::slsqp:
      return {1e-9, 1e-22, 3e-6, 400};
    case Solver::mma:
    case Solver::ccsaq:
      return {1e-6, 1e-7, 3e-2, 20000};
    case Solver::cobyla:
    case Solver::bobyqa:
      return {1e-6, 1e-7, 3e-2, 50000};
    case Solver::ipopt:
      return {1e-8, 1e-13, 1e-5, 400};
  }
  return {};
}

double distance(const Model& model, std::span<const double> a, std::span<const double> b) {
  double out = 0;
  for (std::size_t i = 0; i < b.size(); ++i) {
    out = std::max(out, std::abs(a[i] - b[i]) / model.variables()[i].scale);
  }
  return out;
}

double objective_at(const Model& model, std::span<const double> x) {
  std::vector<double> r(model.residual_count());
  EXPECT_TRUE(model.residuals(x, r, {}, {}));
  double squares = 0, largest = 0;
  for (const double value : r) {
    squares += value * value;
    largest = std::max(largest, std::abs(value));
  }
  return model.objective() == Objective::max_abs ? largest : squares;
}

/// Largest violation of constraints and bounds, without the library.
double violation_at(const Model& model, std::span<const double> x) {
  std::vector<double> c(model.constraint_count());
  model.constraints(x, c, {});
  double out = 0;
  for (int i = 0; i < model.constraint_count(); ++i) {
    out = std::max(out, i < model.equality_count() ? std::abs(c[i]) : -c[i]);
  }
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Variable& v = model.variables()[i];
    out = std::max({out, v.lower - x[i], x[i] - v.upper});
  }
  return out;
}

std::vector<double> clamped(const Model& model, std::vector<double> x) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] = std::clamp(x[i], model.variables()[i].lower, model.variables()[i].upper);
  }
  return x;
}

[[nodiscard]] ::testing::AssertionResult reached(const Problem& problem, const Solution& solution,
                                                 const Accuracy& accuracy, double start_objective) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Problem::Minimum& minimum : problem.minima) {
    const double allowed = minimum.objective > 0 ? accuracy.objective * minimum.objective
                                                 : accuracy.zero * start_objective;
    const double away = distance(problem.model, solution.x, minimum.x);
    nearest = std::min(nearest, away);
    if (std::abs(solution.objective - minimum.objective) > allowed) continue;
    if (away <= accuracy.point || !accuracy.point || problem.singular)
      return ::testing::AssertionSuccess();
  }
  return ::testing::AssertionFailure()
         << "objective " << solution.objective << ", x " << ::testing::PrintToString(solution.x)
         << ", " << nearest << " from the nearest minimum, stop "
         << static_cast<int>(solution.stop);
}

class EverySolver : public ::testing::TestWithParam<Solver> {};

TEST_P(EverySolver, ReachesTheKnownMinima) {
  int solved = 0;
  for (const Problem& problem : all_problems()) {
    if (!can_solve(GetParam(), problem.model)) continue;
    if (is_global(GetParam()) && problem.rugged) continue;
    const Accuracy expected = accuracy(GetParam(), problem);
    for (const std::vector<double>& start : problem.starts) {
      SCOPED_TRACE(problem.name + " from " + ::testing::PrintToString(start));
      const Solution solution =
          solve(GetParam(), problem.model, start,
                {.max_iterations = expected.iterations, .search_evaluations = kShortSearch});
      const double before = objective_at(problem.model, clamped(problem.model, start));
      EXPECT_TRUE(reached(problem, solution, expected, before));
      // A singular minimum is approached linearly, for ever.
      if (!problem.singular && !creeps(GetParam())) {
        EXPECT_EQ(solution.stop, Stop::converged);
      }
      // The order of summation may differ.
      EXPECT_NEAR(solution.objective, objective_at(problem.model, solution.x),
                  1e-14 * solution.objective);
      EXPECT_LE(violation_at(problem.model, solution.x), 1e-9);
      ++solved;
    }
  }
  EXPECT_GE(solved, 10);
}

TEST_P(EverySolver, StopsWhereTheModelHasNoValue) {
  const Problem problem = bounded_problems().back();
  const Solution solution = solve(GetParam(), problem.model, std::vector{-1.0});
  EXPECT_EQ(solution.stop, Stop::no_value);
  EXPECT_EQ(solution.x, std::vector{-1.0});
}

TEST_P(EverySolver, StopsAtTheIterationLimit) {
  const Problem problem = unconstrained_problems().front();
  const Solution solution =
      solve(GetParam(), problem.model, problem.starts.front(), {.max_iterations = 3});
  EXPECT_EQ(solution.stop, Stop::iteration_limit);
  EXPECT_LE(solution.iterations, 4);
  EXPECT_LE(solution.objective, objective_at(problem.model, problem.starts.front()));
}

TEST_P(EverySolver, StopsAtTheTimeLimit) {
  const Problem problem = unconstrained_problems().front();
  const Solution solution =
      solve(GetParam(), problem.model, problem.starts.front(), {.time_limit = 0});
  EXPECT_EQ(solution.stop, Stop::time_limit);
}

TEST_P(EverySolver, IsInterruptedOnTheWay) {
  std::atomic<bool> interrupted = false;
  int calls = 0;
  FunctionModel::Parts parts{free_variables(2), rosenbrock};
  parts.has_value = [&](auto) {
    if (++calls == 5) interrupted = true;
    return true;
  };
  const FunctionModel model(parts);
  const Solution solution =
      solve(GetParam(), model, std::vector{-1.2, 1.0}, {.interrupted = &interrupted});
  EXPECT_EQ(solution.stop, Stop::interrupted);
  EXPECT_LT(calls, 40);
}

TEST_P(EverySolver, HeedsAnInterruptBeforeItBegins) {
  const std::atomic<bool> interrupted = true;
  const Problem problem = unconstrained_problems().front();
  const Solution solution =
      solve(GetParam(), problem.model, problem.starts.front(), {.interrupted = &interrupted});
  EXPECT_EQ(solution.stop, Stop::interrupted);
  EXPECT_EQ(solution.x, problem.starts.front());
}

TEST_P(EverySolver, CountsWhatItAsksOfTheModel) {
  std::uint64_t calls = 0;
  FunctionModel::Parts parts{free_variables(2), rosenbrock};
  parts.has_value = [&](auto) {
    ++calls;
    return true;
  };
  const FunctionModel model(parts);
  const Solution solution =
      solve(GetParam(), model, std::vector{-1.2, 1.0}, {.search_evaluations = kShortSearch});
  // A call for the Jacobian may count as an evaluation too.
  EXPECT_LE(solution.evaluations, calls);
  EXPECT_GE(solution.evaluations + solution.gradients, calls);
}

TEST_P(EverySolver, SaysWhatIsInfeasible) {
  if (GetParam() == Solver::ceres) GTEST_SKIP() << "refuses constraints, as a test of its own says";
  const FunctionModel model({boxes({{-5, 5}, {-5, 5}}), rosenbrock, [](Point x) -> Values {
                               return {x[0] + x[1] - 3.0, 1.0 - x[0] - x[1]};
                             }});
  const Solution solution = solve(GetParam(), model, std::vector{-1.2, 1.0});
  // An augmented Lagrangian goes on raising its penalties.
  const bool gave_up = creeps(GetParam()) && solution.stop == Stop::iteration_limit;
  EXPECT_TRUE(solution.stop == Stop::infeasible || gave_up) << static_cast<int>(solution.stop);
  EXPECT_GE(solution.violation, 1 - 1e-9);  // no point violates both by less
}

TEST_P(EverySolver, SaysWhichEqualitiesContradict) {
  if (GetParam() == Solver::ceres) GTEST_SKIP() << "refuses constraints, as a test of its own says";
  FunctionModel::Parts parts{boxes({{-5, 5}, {-5, 5}}), rosenbrock, [](Point x) -> Values {
                               return {x[0] + x[1] - 3.0, x[0] + x[1] - 1.0};
                             }};
  parts.equality_count = 2;
  const Solution solution = solve(GetParam(), FunctionModel(parts), std::vector{-1.2, 1.0});
  // An augmented Lagrangian goes on raising its penalties.
  const bool gave_up = creeps(GetParam()) && solution.stop == Stop::iteration_limit;
  EXPECT_TRUE(solution.stop == Stop::infeasible || gave_up) << static_cast<int>(solution.stop);
  EXPECT_GE(solution.violation, 1 - 1e-9);
}

TEST_P(EverySolver, PassesOnWhatTheModelThrows) {
  FunctionModel::Parts parts{free_variables(2), rosenbrock};
  int calls = 0;
  parts.has_value = [&](auto) -> bool {
    if (++calls == 4) throw std::runtime_error("from the model");
    return true;
  };
  const FunctionModel model(parts);
  EXPECT_THROW((void)solve(GetParam(), model, std::vector{-1.2, 1.0}), std::runtime_error);
}

TEST_P(EverySolver, LeavesAFullyFixedModelAlone) {
  const FunctionModel model({boxes({{0.5, 0.5}, {2, 2}}), rosenbrock});
  const Solution solution = solve(GetParam(), model, std::vector{0.0, 0.0});
  EXPECT_EQ(solution.stop, Stop::converged);
  EXPECT_EQ(solution.x, (std::vector{0.5, 2.0}));
  EXPECT_DOUBLE_EQ(solution.objective, 100 * 1.75 * 1.75 + 0.25);
}

INSTANTIATE_TEST_SUITE_P(Solver, EverySolver, ::testing::ValuesIn(all_solvers()),
                         [](const auto& info) {
                           std::string out(name(info.param));
                           std::erase(out, '-');
                           return out;
                         });

TEST(Ceres, RefusesConstraintsAndMinimax) {
  for (const auto& problems : {constrained_problems(), minimax_problems()}) {
    const Problem& problem = problems.front();
    EXPECT_FALSE(can_solve(Solver::ceres, problem.model));
    const Solution solution = solve(Solver::ceres, problem.model, problem.starts.front());
    EXPECT_EQ(solution.stop, Stop::failed);
    EXPECT_EQ(solution.x, problem.starts.front());
    EXPECT_DOUBLE_EQ(solution.objective, objective_at(problem.model, problem.starts.front()));
  }
}

/// The multipliers of problem 43 are 1, 0 and 2 in ∇‖r‖² = Σ λᵢ ∇cᵢ (from the stationarity of the
/// Lagrangian at (0, 1, 2, −1)).
TEST(Ipopt, GivesMultipliers) {
  const Problem hs43 = constrained_problems()[1];
  ASSERT_EQ(hs43.name, "hs43");
  const Solution solution = solve(Solver::ipopt, hs43.model, hs43.starts.front());
  ASSERT_EQ(solution.multipliers.size(), 3u);
  EXPECT_NEAR(solution.multipliers[0], 1, 1e-5);
  EXPECT_NEAR(solution.multipliers[1], 0, 1e-5);
  EXPECT_NEAR(solution.multipliers[2], 2, 1e-5);
}

/// The multipliers of a minimax problem are the sensitivity of its value: the error of x² ≈ a + bx
/// over [−1, 1] with b ≥ β is (1 + β + β²/4)/2, so λ = 1/2 + β/4.
TEST(Multipliers, OfMinimaxAreItsSensitivities) {
  const Problem problem = minimax_problems().back();
  for (const Solver solver : {Solver::ipopt, Solver::gauss_newton}) {
    for (const bool learns : {false, true}) {
      const Solution solution =
          solve(solver, problem.model, problem.starts.front(), {.learns_curvature = learns});
      ASSERT_EQ(solution.multipliers.size(), 1u);
      EXPECT_NEAR(solution.multipliers[0], 0.5 + 0.5 / 4, 1e-6);
    }
  }
}

/// Of problem 42: ∇f = (2, 0, 2(x₃ − 3), 2(x₄ − 4)) is λ₁ (1, 0, 0, 0) + λ₂ (0, 0, 2x₃, 2x₄) with
/// λ₁ = 2 and λ₂ = 1 − 3/x₃.
TEST(Multipliers, OfEqualitiesHaveTheirSign) {
  const Problem hs42 = equality_problems()[2];
  ASSERT_EQ(hs42.name, "hs42");
  for (const Solver solver : {Solver::ipopt, Solver::gauss_newton}) {
    const Solution solution = solve(solver, hs42.model, hs42.starts.front());
    ASSERT_EQ(solution.multipliers.size(), 2u);
    EXPECT_NEAR(solution.multipliers[0], 2, 1e-5);
    EXPECT_NEAR(solution.multipliers[1], 1 - 5 / std::sqrt(2.0), 1e-5);
  }
}

/// From the solution with its multipliers; without, the multipliers have to be found again.
TEST(Ipopt, StartsWarm) {
  for (const Problem& problem : constrained_problems()) {
    SCOPED_TRACE(problem.name);
    const Solution cold = solve(Solver::ipopt, problem.model, problem.starts.front());
    const Solution again = solve(Solver::ipopt, problem.model, cold.x);
    const Solution warm =
        solve(Solver::ipopt, problem.model, cold.x, {.multipliers = cold.multipliers});
    EXPECT_NEAR(warm.objective, problem.minima.front().objective,
                1e-8 * problem.minima.front().objective);
    EXPECT_LT(warm.iterations, again.iterations);
  }
}

TEST(Ipopt, ServesTwoThreadsAtOnce) {
  const std::vector<Problem> problems = constrained_problems();
  std::atomic<int> wrong = 0;
  {
    std::vector<std::jthread> threads;
    for (int thread = 0; thread < 2; ++thread) {
      threads.emplace_back([&] {
        for (int i = 0; i < 20; ++i) {
          const Problem& problem = problems[i % problems.size()];
          const Solution solution = solve(Solver::ipopt, problem.model, problem.starts.front());
          const double minimum = problem.minima.front().objective;
          if (!(std::abs(solution.objective - minimum) <= 1e-8 * minimum)) ++wrong;
        }
      });
    }
  }
  EXPECT_EQ(wrong, 0);
}

}  // namespace
}  // namespace cognate::synthesis::testing::solver_test
