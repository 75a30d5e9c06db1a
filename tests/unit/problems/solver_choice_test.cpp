/// Every solver that a file may name solves problems of both kinds, the same for any number of
/// threads.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "analysis/linkage/motion.hpp"
#include "problems/basics/names.hpp"
#include "problems/linkage/result.hpp"

namespace cognate::problems::solver_choice_test {
namespace {

class SolverChoiceTest : public ::testing::TestWithParam<synthesis::Solver> {
 protected:
  template <class Problem>
  Result solved(Problem problem) const {
    problem.solve.solver = GetParam();
    problem.solve.starts = 6;
    problem.solve.designs = 1;
    const Result one = solve(problem, {.seed = 5, .threads = 1});
    const Result three = solve(problem, {.seed = 5, .threads = 3});
    EXPECT_EQ(one.status, three.status);
    EXPECT_EQ(one.designs.size(), three.designs.size());
    if (one.designs.empty() || three.designs.empty()) return one;
    EXPECT_EQ(one.designs.front().error.sum_of_squares, three.designs.front().error.sum_of_squares);
    EXPECT_EQ(one.designs.front().crank_angles, three.designs.front().crank_angles);
    const bool other = GetParam() != synthesis::Solver::automatic;
    const std::string name(other ? to_string(GetParam()) : "gauss-newton");
    EXPECT_NE(one.designs.front().origin.find(name), std::string::npos);
    // The solver named goes on from what Gauss-Newton has found.
    if (other && GetParam() != synthesis::Solver::gauss_newton) {
      problem.solve.solver = synthesis::Solver::gauss_newton;
      const Result without = solve(problem, {.seed = 5, .threads = 1});
      EXPECT_GT(one.work.positions, without.work.positions);
    }
    return one;
  }
};

const FourBar kPlanted{{0.2, -0.3}, {2.1, 0.9}, 0.8, 1.9, 1.6, Assembly::open, Vec2d{1.1, 0.7}};

TEST_P(SolverChoiceTest, MeetsAPlantedPath) {
  PathProblem problem;
  problem.timing = Timing::prescribed;
  problem.crank_reference = CrankReference::global;
  for (int j = 0; j < 8; ++j) {
    problem.crank_angles.push_back(0.3 + 0.7 * j);
    problem.points.push_back(*Motion(kPlanted).at(problem.crank_angles.back())->coupler_point);
  }
  problem.weights.assign(problem.points.size(), 1);
  const Result result = solved(problem);
  ASSERT_EQ(result.status, Status::solved);
  EXPECT_LT(result.designs.front().error.max, 1e-9);
}

TEST_P(SolverChoiceTest, MeetsAPlantedFunction) {
  const auto rocker_angle = [&](double input) {
    const Vec2d c = Motion(kPlanted).at(0.6 + input)->c - kPlanted.pivot_d;
    return std::atan2(c.y, c.x);
  };
  FunctionProblem problem;
  AnglePairs pairs;
  for (int i = 0; i < 7; ++i) pairs.emplace_back(0.2 * i, rocker_angle(0.2 * i) - rocker_angle(0));
  problem.target = pairs;
  problem.given.crank = 1;
  const Result result = solved(problem);
  ASSERT_EQ(result.status, Status::solved);
  EXPECT_LT(result.designs.front().error.max, 1e-6);
}

TEST_P(SolverChoiceTest, LeavesWhatIsGivenWhole) {
  for (const Timing timing : {Timing::free, Timing::mixed, Timing::prescribed}) {
    PathProblem problem;
    problem.timing = timing;
    problem.crank_reference = CrankReference::global;
    for (int j = 0; j < 5; ++j) {
      if (timing != Timing::free) problem.crank_angles.push_back(0.3 + 0.7 * j);
      problem.has_crank_angle.push_back(j % 2 == 0);
      problem.points.push_back(*Motion(kPlanted).at(0.3 + 0.7 * j)->coupler_point);
    }
    problem.weights.assign(problem.points.size(), 1);
    problem.given = {.crank = kPlanted.crank,
                     .coupler = kPlanted.coupler,
                     .rocker = kPlanted.rocker,
                     .pivot_a = kPlanted.pivot_a,
                     .pivot_d = kPlanted.pivot_d,
                     .coupler_point = kPlanted.coupler_point};
    problem.solve.solver = GetParam();
    problem.solve.starts = 20;
    const Result result = solve(problem, {});
    ASSERT_EQ(result.status, Status::solved);
    EXPECT_LT(result.designs.front().error.max, 1e-7);
  }
}

TEST_P(SolverChoiceTest, MeasuresAFunctionGeneratorGivenWhole) {
  FunctionProblem problem;
  problem.target = AnglePairs{{0, 0}, {0.3, 0.1}, {0.6, 0.25}};
  problem.given = {.crank = 1, .coupler = 3, .rocker = 2.5, .frame = 3.2};
  problem.input_start = 0.5;
  problem.output_start = 1.6;
  problem.solve.solver = GetParam();
  const Result result = solve(problem, {});
  ASSERT_FALSE(result.designs.empty());
  const FourBar linkage = four_bar(result.designs.front());
  double squares = 0;
  for (const auto& [input, output] : std::get<AnglePairs>(problem.target)) {
    const Vec2d c = Motion(linkage).at(0.5 + input)->c - linkage.pivot_d;
    const double error = std::atan2(c.y, c.x) - 1.6 - output;
    squares += error * error;
  }
  EXPECT_NEAR(result.designs.front().error.sum_of_squares, squares, 1e-12);
}

std::vector<synthesis::Solver> all_solvers() {
  std::vector<synthesis::Solver> all;
  for (const auto& named : names<synthesis::Solver>()) all.push_back(named.value);
  return all;
}

INSTANTIATE_TEST_SUITE_P(Solver, SolverChoiceTest, ::testing::ValuesIn(all_solvers()),
                         [](const auto& info) {
                           std::string out(to_string(info.param));
                           std::erase(out, '-');
                           return out;
                         });

}  // namespace
}  // namespace cognate::problems::solver_choice_test
