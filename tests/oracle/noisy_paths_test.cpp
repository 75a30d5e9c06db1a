/// Targets with noise: nothing is infeasible for the order of its points alone, any order is no
/// worse than that given, and no design is worse than the one the target was planted with.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <random>

#include "analysis/linkage/motion.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/linkage/result.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/read.hpp"

namespace cognate::problems {
namespace {

PathProblem problem_of(const char* name) {
  const auto problem =
      read_problem(std::filesystem::path(COGNATE_ORACLE_DIR) / "noisy_paths" / name);
  return std::get<PathProblem>(*problem);
}

/// The least sum of squares of a solved problem.
double least(const PathProblem& problem) {
  const Result result = solve(problem, {});
  EXPECT_EQ(result.status, Status::solved);
  EXPECT_FALSE(result.designs.empty());
  if (result.designs.empty()) return std::numeric_limits<double>::infinity();
  EXPECT_TRUE(all_satisfied(result.designs[0].constraints));
  EXPECT_TRUE(result.designs[0].metrics.defects.empty());
  return result.designs[0].error.sum_of_squares;
}

// A feasible design of that error is known.
TEST(NoisyPaths, AFigureEightWithLimitsHasDesigns) {
  EXPECT_LE(least(problem_of("figure_eight_with_limits.toml")), 184.7);
}

// The error of the planted linkage at its own crank angles.
TEST(NoisyPaths, AnArcOfTwelvePointsIsNoWorseThanPlanted) {
  EXPECT_LE(least(problem_of("arc_of_12_points.toml")), 2.415e-3);
}

// The least found in order by searches of several seeds.
TEST(NoisyPaths, AnyOrderIsNoWorseThanTheOneGiven) {
  PathProblem problem = problem_of("turn_of_40_points.toml");
  ASSERT_EQ(problem.order, PointOrder::any);
  const double any = least(problem);
  problem.order = PointOrder::cyclic;
  const double cyclic = least(problem);
  EXPECT_LE(cyclic, 5.47e-3);
  EXPECT_LE(any, cyclic * (1 + 1e-9));
}

/// Points of a planted crank-rocker's turn with noise of one percent.
PathProblem long_list(int count, PointOrder order) {
  const FourBar linkage{{0, 0}, {2, 0.5}, 0.6, 1.9, 1.6, Assembly::open, Vec2d{1.1, 0.7}};
  std::mt19937_64 random(5);
  std::normal_distribution<double> noise(0, 0.005);
  PathProblem problem;
  problem.order = order;
  for (int j = 0; j < count; ++j) {
    const double angle = 0.3 + kTurn * (j + 0.3) / count;
    const Vec2d at = *Motion(linkage).at(angle)->coupler_point;
    problem.points.push_back(at + Vec2d{noise(random), noise(random)});
  }
  return problem;
}

TEST(NoisyPaths, LongListsAreSolvedInEitherOrder) {
  for (const int count : {100, 1000}) {
    PathProblem problem = long_list(count, PointOrder::cyclic);
    // Less than the noise, of which the fit takes a part.
    const double noise = 2 * count * 0.005 * 0.005;
    EXPECT_LE(least(problem), 1.1 * noise) << count;
    problem.order = PointOrder::any;
    EXPECT_LE(least(problem), 1.1 * noise) << count;
  }
}

}  // namespace
}  // namespace cognate::problems
