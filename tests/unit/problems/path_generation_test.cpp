/// Path generation as a user meets it: planted linkages are found again, with any options.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "analysis/linkage/motion.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/linkage/result.hpp"
#include "problems/linkage/verify.hpp"

namespace cognate::problems::path_generation_test {
namespace {

/// A crank-rocker with a coupler curve of size 1.
const FourBar planted{{0.2, -0.3}, {2.1, 0.9}, 0.8, 1.9, 1.6, Assembly::open, Vec2d{1.1, 0.7}};

std::vector<double> angles(int count, double from, double to) {
  std::vector<double> all;
  for (int j = 0; j < count; ++j) all.push_back(from + (to - from) * j / (count - 1));
  return all;
}

PathProblem on_curve(const std::vector<double>& crank_angles, double scale = 1, Vec2d shift = {}) {
  PathProblem problem;
  for (const double angle : crank_angles) {
    problem.points.push_back(scale * *Motion(planted).at(angle)->coupler_point + shift);
  }
  problem.constraints.required_class = RequiredClass::crank_rocker;
  return problem;
}

PathProblem timed(const std::vector<double>& crank_angles, CrankReference reference) {
  PathProblem problem = on_curve(crank_angles);
  problem.timing = Timing::prescribed;
  problem.crank_reference = reference;
  for (const double angle : crank_angles) {
    const double offset = reference == CrankReference::frame ? frame_angle(planted) : 0;
    problem.crank_angles.push_back(angle - offset);
  }
  return problem;
}

void expect_planted(const FourBar& found, double scale = 1, Vec2d shift = {}) {
  const double tolerance = 1e-6 * scale;
  EXPECT_NEAR(found.crank, scale * planted.crank, tolerance);
  EXPECT_NEAR(found.coupler, scale * planted.coupler, tolerance);
  EXPECT_NEAR(found.rocker, scale * planted.rocker, tolerance);
  EXPECT_NEAR(found.pivot_a.x, scale * planted.pivot_a.x + shift.x, tolerance);
  EXPECT_NEAR(found.pivot_d.y, scale * planted.pivot_d.y + shift.y, tolerance);
  EXPECT_EQ(found.assembly, planted.assembly);
}

/// Whether `planted` or its timed cognate, the other crank-rocker of the same curve, is among them.
bool contains_planted(const Result& result, double scale = 1) {
  return std::any_of(result.designs.begin(), result.designs.end(), [&](const Design& design) {
    return std::abs(four_bar(design).crank - scale * planted.crank) < 1e-5 * scale &&
           std::abs(four_bar(design).rocker - scale * planted.rocker) < 1e-5 * scale;
  });
}

TEST(PathGeneration, FindsAPlantedLinkageWithPrescribedTiming) {
  for (const auto reference :
       {CrankReference::first, CrankReference::frame, CrankReference::global}) {
    PathProblem problem = timed(angles(9, 0.3, 5.5), reference);
    problem.crank_sense = CrankSense::ccw;
    const Result result = solve(problem, {});
    ASSERT_EQ(result.status, Status::solved);
    EXPECT_LT(result.designs[0].error.sum_of_squares, 1e-20);
    EXPECT_TRUE(contains_planted(result));
    EXPECT_TRUE(result.designs[0].metrics.defects.empty());
  }
}

TEST(PathGeneration, FindsAPlantedLinkageFromFourteenPoints) {
  const Result result = solve(on_curve(angles(14, 0.3, 6.1)), {});
  ASSERT_EQ(result.status, Status::solved);
  EXPECT_LT(result.designs[0].error.sum_of_squares, 1e-20);
  EXPECT_TRUE(contains_planted(result));
  ASSERT_GE(result.designs.size(), 2u);
  EXPECT_EQ(result.designs[1].cognate_of, 0);
}

TEST(PathGeneration, FindsItInAnyOrderOfThePoints) {
  auto shuffled = angles(14, 0.3, 6.1);
  std::swap(shuffled[1], shuffled[8]);
  std::swap(shuffled[3], shuffled[12]);
  std::swap(shuffled[0], shuffled[5]);
  PathProblem problem = on_curve(shuffled);
  problem.order = PointOrder::any;
  const Result result = solve(problem, {});
  ASSERT_EQ(result.status, Status::solved);
  EXPECT_LT(result.designs[0].error.sum_of_squares, 1e-20);
}

TEST(PathGeneration, KeepsWhatTheFileFixes) {
  PathProblem problem = on_curve(angles(12, 0.3, 6.0));
  problem.given.pivot_d = planted.pivot_d;
  problem.given.crank = planted.crank;
  const Result result = solve(problem, {});
  ASSERT_EQ(result.status, Status::solved);
  EXPECT_EQ(four_bar(result.designs[0]).pivot_d, planted.pivot_d);
  EXPECT_EQ(four_bar(result.designs[0]).crank, planted.crank);
  EXPECT_LT(result.designs[0].error.sum_of_squares, 1e-18);
  expect_planted(four_bar(result.designs[0]));
}

TEST(PathGeneration, MovesAndGrowsWithItsPoints) {
  const auto crank_angles = angles(12, 0.3, 6.0);
  for (const double scale : {1e-30, 1e-3, 1e4, 1e30}) {
    const Vec2d shift{3 * scale, -2 * scale};
    const Result result = solve(on_curve(crank_angles, scale, shift), {});
    ASSERT_EQ(result.status, Status::solved) << scale;
    EXPECT_TRUE(contains_planted(result, scale)) << scale;
  }
}

TEST(PathGeneration, TurnsTheCrankInTheSenseAskedFor) {
  // The points follow one another counter-clockwise; reversed, they ask for the other sense.
  auto crank_angles = angles(11, 0.3, 6.0);
  std::reverse(crank_angles.begin(), crank_angles.end());
  PathProblem problem = on_curve(crank_angles);
  problem.crank_sense = CrankSense::cw;
  const Result result = solve(problem, {});
  ASSERT_EQ(result.status, Status::solved);
  EXPECT_LT(result.designs[0].error.sum_of_squares, 1e-20);
  EXPECT_TRUE(contains_planted(result));
}

TEST(PathGeneration, WeighsPointsButReportsPlainErrors) {
  PathProblem problem = on_curve(angles(12, 0.3, 6.0));
  for (std::size_t j = 0; j < 12; ++j) problem.points[j].x += 0.05 * std::sin(7.0 * double(j));
  const Result plain = solve(problem, {});
  problem.weights.assign(12, 1.0);
  problem.weights[4] = 1e4;
  const Result weighted = solve(problem, {});
  ASSERT_EQ(weighted.status, Status::solved);
  const auto distance = [&](const Design& design) {
    const auto pose = Motion(four_bar(design)).at(design.crank_angles[4]);
    return squared_norm(*pose->coupler_point - problem.points[4]);
  };
  EXPECT_LT(distance(weighted.designs[0]), 0.01 * distance(plain.designs[0]));
  EXPECT_GE(weighted.designs[0].error.sum_of_squares, plain.designs[0].error.sum_of_squares);
  const auto again =
      path_error(four_bar(weighted.designs[0]), problem.points, weighted.designs[0].crank_angles);
  EXPECT_EQ(weighted.designs[0].error.sum_of_squares, again.sum_of_squares);
}

TEST(PathGeneration, GivesTheSameDesignsOnAnyNumberOfThreads) {
  PathProblem problem = on_curve(angles(8, 0.3, 4.0));
  problem.points[3].x += 0.1;
  problem.solve.starts = 200;
  problem.solve.designs = 10;
  const Result one = solve(problem, {.seed = 5, .threads = 1});
  const Result three = solve(problem, {.seed = 5, .threads = 3});
  ASSERT_EQ(one.designs.size(), three.designs.size());
  for (std::size_t i = 0; i < one.designs.size(); ++i) {
    const Design &a = one.designs[i], &b = three.designs[i];
    EXPECT_EQ(four_bar(a).crank, four_bar(b).crank);
    EXPECT_EQ(four_bar(a).pivot_d, four_bar(b).pivot_d);
    EXPECT_EQ(a.crank_angles, b.crank_angles);
    EXPECT_EQ(a.error.sum_of_squares, b.error.sum_of_squares);
  }
  EXPECT_EQ(one.work.positions, three.work.positions);
}

TEST(PathGeneration, ReturnsAsManyDifferentDesignsAsAskedFor) {
  PathProblem problem = on_curve(angles(13, 0.3, 6.0));
  problem.points[3].x += 0.1;
  problem.solve.designs = 12;
  const Result result = solve(problem, {});
  ASSERT_EQ(result.designs.size(), 12u);
  for (std::size_t i = 1; i < result.designs.size(); ++i) {
    const Design& design = result.designs[i];
    EXPECT_GE(design.error.sum_of_squares, result.designs[i - 1].error.sum_of_squares * (1 - 1e-9));
    for (const ConstraintCheck& check : design.constraints) EXPECT_TRUE(check.satisfied);
  }
}

TEST(PathGeneration, KeepsTheTransmissionAngleWithoutAClass) {
  PathProblem problem = on_curve(angles(13, 0.3, 6.0));
  problem.constraints.required_class.reset();
  const double free_error = solve(problem, {}).designs.at(0).error.sum_of_squares;
  problem.constraints.transmission_angle = Range{0.9, 2.2};
  const Result result = solve(problem, {});
  ASSERT_EQ(result.status, Status::solved);
  EXPECT_GE(result.designs[0].error.sum_of_squares, free_error);
  int closed = 0;
  for (int step = 0; step < 360; ++step) {
    const auto pose = Motion(four_bar(result.designs[0])).at(step * kPi / 180);
    if (!pose) continue;
    ++closed;
    EXPECT_GT(pose->transmission_angle, 0.9 - 1e-9);
    EXPECT_LT(pose->transmission_angle, 2.2 + 1e-9);
  }
  EXPECT_GT(closed, 180);
}

TEST(PathGeneration, KeepsCrankAnglesWhereSomePointsAreTimed) {
  const auto crank_angles = angles(11, 0.3, 5.4);
  int timed_points = 0;
  for (const auto reference :
       {CrankReference::first, CrankReference::frame, CrankReference::global}) {
    PathProblem problem = timed(crank_angles, reference);
    problem.timing = Timing::mixed;
    for (int j = 0; j < 11; ++j) problem.has_crank_angle.push_back(j == 2 || j == 3 || j == 9);
    const Result result = solve(problem, {});
    ASSERT_EQ(result.status, Status::solved);
    const Design& best = result.designs[0];
    EXPECT_LT(best.error.sum_of_squares, 1e-18);
    EXPECT_TRUE(best.metrics.defects.empty());
    const auto turned = [&](int from, int to) {
      const double wanted = crank_angles[to] - crank_angles[from];
      const double found = best.crank_angles[to] - best.crank_angles[from];
      return std::abs(std::remainder(std::abs(wanted) - std::abs(found), kTurn));
    };
    EXPECT_LT(std::min(turned(2, 3), 1.0), 1e-9);
    if (reference == CrankReference::first) continue;
    const double zero = reference == CrankReference::frame ? frame_angle(four_bar(best)) : 0;
    for (const int j : {2, 3, 9}) {
      const double off = best.crank_angles[j] - zero - problem.crank_angles[j];
      EXPECT_NEAR(std::remainder(off, kTurn), 0, 1e-9) << "point " << j;
      ++timed_points;
    }
  }
  EXPECT_EQ(timed_points, 6);
}

TEST(PathGeneration, EveryDesignKeepsCrankAnglesCountedFromTheXAxis) {
  const auto crank_angles = angles(9, 0.3, 5.4);
  PathProblem problem = timed(crank_angles, CrankReference::global);
  problem.solve.designs = 6;
  const Result result = solve(problem, {});
  ASSERT_EQ(result.status, Status::solved);
  for (const Design& design : result.designs) {
    for (std::size_t j = 0; j < crank_angles.size(); ++j) {
      EXPECT_NEAR(std::remainder(design.crank_angles[j] - crank_angles[j], kTurn), 0, 1e-9);
    }
  }
}

TEST(PathGeneration, AWholeTurnEndsWhereItBeganWithSomePointsTimed) {
  for (const auto reference : {CrankReference::frame, CrankReference::global}) {
    PathProblem problem = timed(angles(10, 0.35, 0.35 + kTurn), reference);
    problem.timing = Timing::mixed;
    problem.points.back() = problem.points.front();
    // As a reader makes them of 20 and 380 degrees, say: to rounding a whole turn.
    problem.crank_angles.back() = std::nextafter(problem.crank_angles.front() + kTurn, 100);
    for (int j = 0; j < 10; ++j) problem.has_crank_angle.push_back(j == 0 || j == 9);
    const Result result = solve(problem, {});
    ASSERT_EQ(result.status, Status::solved);
    EXPECT_LT(result.designs[0].error.max, 1e-8);
  }
}

TEST(PathGeneration, TakesLongListsOfPoints) {
  for (const auto timing : {Timing::free, Timing::prescribed, Timing::mixed}) {
    const auto crank_angles = angles(800, 0.3, 6.1);
    PathProblem problem = timing == Timing::free ? on_curve(crank_angles)
                                                 : timed(crank_angles, CrankReference::first);
    problem.timing = timing;
    for (int j = 0; j < 800; ++j) problem.has_crank_angle.push_back(j % 100 == 77);
    problem.solve.starts = 150;
    const Result result = solve(problem, {});
    ASSERT_EQ(result.status, Status::solved);
    EXPECT_LT(result.designs[0].error.sum_of_squares, 1e-18);
    EXPECT_EQ(result.designs[0].crank_angles.size(), 800u);
    EXPECT_TRUE(contains_planted(result));
  }
}

TEST(PathGeneration, ReportsTheLeastViolatingDesignWhereNoneIsFeasible) {
  // The path is ten times as large as links of these lengths can draw about these pivots.
  PathProblem problem = on_curve(angles(8, 0.3, 6.0), 10);
  problem.bounds.pivot_a = Box{{-0.1, -0.1}, {0.1, 0.1}};
  problem.constraints.transmission_angle = Range{1.5, 1.6};
  problem.constraints.link_ratio_max = 1.5;
  problem.solve.starts = 10;
  const Result result = solve(problem, {});
  EXPECT_EQ(result.status, Status::infeasible);
  ASSERT_FALSE(result.designs.empty());
  EXPECT_FALSE(all_satisfied(result.designs[0].constraints));
}

TEST(PathGeneration, StopsOnRequest) {
  const std::atomic<bool> interrupted{true};
  EXPECT_EQ(solve(on_curve(angles(8, 0.3, 6.0)), {.interrupted = &interrupted}).status,
            Status::interrupted);
  EXPECT_EQ(solve(on_curve(angles(8, 0.3, 6.0)), {.time_limit = 0.0}).status, Status::time_limit);
}

}  // namespace
}  // namespace cognate::problems::path_generation_test
