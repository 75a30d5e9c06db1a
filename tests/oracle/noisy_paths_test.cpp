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
#include "tests/support/folders.hpp"

namespace cognate::problems::noisy_paths_test {
namespace {

PathProblem problem_of(const char* name) {
  const auto problem = read_task(std::filesystem::path(kOracleFolder) / "noisy_paths" / name);
  return std::get<PathProblem>(*problem);
}

/// The least sum of squares of a solved problem.
double least(const PathProblem& problem, std::uint64_t seed = 1) {
  const Result result = solve(problem, {.seed = seed});
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

/// Sixteen points of a curve that no four-bar traces; order binds and lengths run to a change
/// point.
PathProblem free_closed_curve() {
  PathProblem problem;
  for (int k = 0; k < 16; ++k) {
    const double t = 2 * std::numbers::pi * k / 16;
    problem.points.push_back(
        {3 * std::cos(t) + 0.7 * std::cos(2 * t + 0.4) + 0.35 * std::cos(3 * t - 1),
         2 * std::sin(t) - 0.5 * std::sin(2 * t + 1) + 0.3 * std::sin(4 * t)});
  }
  const Range length{0, 50};
  const Box wide{{-50, -50}, {50, 50}};
  problem.bounds.crank = problem.bounds.coupler = problem.bounds.rocker = problem.bounds.frame =
      length;
  problem.bounds.coupler_point = problem.bounds.pivot_a = wide;
  return problem;
}

// The error of a design with crank 4.94006, coupler 12.43440, rocker 6.68155.
TEST(NoisyPaths, EverySeedFindsTheSameBestOfAFreeClosedCurve) {
  const PathProblem problem = free_closed_curve();
  for (const std::uint64_t seed : {1, 2}) {
    EXPECT_LE(least(problem, seed), 1.01 * 0.40652) << seed;
  }
}

// The best of a search eight times as long. Basins as good are small: what the neighbourhood of
// many designs leads to, of all valleys, finds them from every seed.
TEST(NoisyPaths, EverySeedFindsTheBestOfATripleRockerWithLimits) {
  const PathProblem problem = problem_of("triple_rocker_of_16_points.toml");
  for (const std::uint64_t seed : {1, 2}) {
    EXPECT_LE(least(problem, seed), 1.02 * 0.0050504) << seed;
  }
}

// The points of a triple-rocker that keeps all limits, to rounding. Descents of most starts lead to
// cranks that turn fully, on whose way the transmission angle leaves its limits.
TEST(NoisyPaths, EverySeedFindsTheLinkageOfAnExactArcWithLimits) {
  const PathProblem problem = problem_of("exact_arc_of_a_triple_rocker.toml");
  for (const std::uint64_t seed : {1, 2}) {
    EXPECT_LE(least(problem, seed), 11 * std::pow(1e-8 * 0.148, 2)) << seed;
  }
}

}  // namespace
}  // namespace cognate::problems::noisy_paths_test
