/// What chains stray between targets, against four-bars closed here by circles that meet, and
/// searches begun from designs that are known.
#include "problems/chain/between_targets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "problems/chain/problem.hpp"

namespace cognate::problems::between_targets_test {
namespace {

struct FourBarChain {
  double crank = 1, coupler = 3, rocker = 2.5, frame = 3.5;
  Vec2d attached{1.2, 2.1};  ///< in the axes from B towards C

  /// The point by trigonometry: the angle of the coupler by the law of cosines at B.
  Vec2d point(double angle) const {
    const Vec2d b{crank * std::cos(angle), crank * std::sin(angle)};
    const double x = frame - b.x, y = -b.y, way = std::hypot(x, y);
    const double at_b =
        std::acos((coupler * coupler + way * way - rocker * rocker) / (2 * coupler * way));
    const double turned = std::atan2(y, x) + at_b;
    return {b.x + attached.x * std::cos(turned) - attached.y * std::sin(turned),
            b.y + attached.x * std::sin(turned) + attached.y * std::cos(turned)};
  }

  synthesis::ChainDesign design() const {
    return {{0, 0, frame, 0, crank, coupler, rocker, attached.x, attached.y}, {0, 0, 0, 1, 0}};
  }
};

ChainPathProblem problem_through(const std::vector<double>& angles, bool closed) {
  ChainPathProblem problem;
  problem.mechanism = "four-bar";
  problem.topologies = topologies("any");
  problem.topologies.resize(1);
  problem.closed = closed;
  for (const double angle : angles) problem.points.push_back(FourBarChain{}.point(angle));
  return problem;
}

double stray(const ChainPathProblem& problem, const std::vector<double>& angles) {
  const ScaledChain chain(problem, problem.topologies.front(), TargetScale{});
  return squared_stray(chain, FourBarChain{}.design(), problem.points, angles);
}

std::vector<double> turn(int count, double sense) {
  std::vector<double> angles;
  for (int i = 0; i < count; ++i) angles.push_back(0.3 + sense * kTurn * i / count);
  return angles;
}

TEST(BetweenTargets, SmoothCurvesMayBulge) {
  for (const int count : {8, 12, 60}) {
    for (const double sense : {1.0, -1.0}) {
      const auto angles = turn(count, sense);
      EXPECT_EQ(stray(problem_through(angles, true), angles), 0) << count;
    }
  }
}

/// The greatest distance of the path from a straight way, brute force.
double distance(const Vec2d& point, const Vec2d& from, const Vec2d& to) {
  double least = kInfinity;
  for (int i = 0; i <= 100000; ++i) {
    const double share = i / 1e5;
    least = std::min(least, std::hypot(from.x + share * (to.x - from.x) - point.x,
                                       from.y + share * (to.y - from.y) - point.y));
  }
  return least;
}

TEST(BetweenTargets, ALoopLeftOutCounts) {
  // The last gap of an open path goes back over most of the turn.
  std::vector<double> angles{0.3, 0.35, 0.4, 0.4 + 0.9 * kTurn};
  const auto problem = problem_through(angles, false);
  std::vector<Vec2d> places;
  for (const double angle : angles) places.push_back(FourBarChain{}.point(angle));
  const auto way = [&](int i) {
    if (i < 0 || i > 2) return 0.0;
    const auto at = static_cast<std::size_t>(i);
    return std::hypot(places[at + 1].x - places[at].x, places[at + 1].y - places[at].y);
  };
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double free = 0.5 * std::max({way(i - 1), way(i), way(i + 1)});
    for (const double share : {0.25, 0.5, 0.75}) {
      const double angle = angles[at] + share * (angles[at + 1] - angles[at]);
      const double beyond =
          distance(FourBarChain{}.point(angle), places[at], places[at + 1]) - free;
      sum += beyond > 0 ? beyond * beyond : 0;
    }
  }
  EXPECT_GT(sum, 0.1);
  EXPECT_NEAR(stray(problem, angles), sum / 9, 1e-8 * sum);
}

TEST(BetweenTargets, TimedPathsSayNothingBetween) {
  const std::vector<double> angles{0.3, 0.35, 0.4, 0.4 + 0.9 * kTurn};
  auto problem = problem_through(angles, false);
  problem.crank_angles = angles;
  EXPECT_EQ(stray(problem, {0}), 0);
}

/// A search of no starts of its own ends where it is begun, in either sense of the crank.
TEST(KnownChains, AreStartsOfASearch) {
  for (const double sense : {1.0, -1.0}) {
    auto problem = problem_through(turn(24, sense), true);
    problem.mechanism = "any";
    problem.topologies = topologies("any");
    problems::Run run;
    run.threads = 1;
    problem.solve.starts = 256;
    const Result found = solve(problem, run);
    ASSERT_FALSE(found.designs.empty());
    run.known = {found.designs.front()};
    problem.solve.starts = 0;
    const Result again = solve(problem, run);
    ASSERT_FALSE(again.designs.empty());
    EXPECT_LE(again.designs.front().error.rms, found.designs.front().error.rms + 1e-9);
    run.known.clear();
    EXPECT_TRUE(solve(problem, run).designs.empty()) << "there is no start at all";
  }
}

}  // namespace
}  // namespace cognate::problems::between_targets_test
