// Designs with limits over the full turn, against a search of a grid.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "analysis/linkage/four_bar.hpp"
#include "analysis/linkage/mobility.hpp"
#include "analysis/linkage/motion.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/function/problem.hpp"
#include "problems/guidance/problem.hpp"
#include "problems/linkage/cycle/cycle_metrics.hpp"
#include "problems/linkage/result.hpp"
#include "problems/path/problem.hpp"
#include "tests/support/driven_linkage.hpp"

namespace cognate::problems::cycle_optima_test {
namespace {

using test::machine;
using test::peak_acceleration;
/// Two dimensions are free and all others given: the best design on a grid that narrows about it.
struct GridSearch {
  PathProblem problem;
  FourBar planted;
  std::vector<double> angles{0.2, 0.9, 1.7, 2.6, 3.6, 4.9};

  /// `set` puts two numbers into the linkage.
  template <class Set, class Allowed>
  double best(const Set& set, const Allowed& allowed, Vec2d middle, double reach) const {
    double least = INFINITY;
    for (int round = 0; round < 14; ++round) {
      constexpr int kSteps = 12;
      Vec2d found = middle;
      for (int i = -kSteps; i <= kSteps; ++i) {
        for (int j = -kSteps; j <= kSteps; ++j) {
          const Vec2d at = middle + (reach / kSteps) * Vec2d{double(i), double(j)};
          FourBar linkage = planted;
          set(linkage, at);
          if (mobility_class(lengths(linkage)) != MobilityClass::crank_rocker) continue;
          const double error = squares(linkage);
          if (error < least && allowed(linkage)) {
            least = error;
            found = at;
          }
        }
      }
      middle = found;
      reach *= 0.5;
    }
    return least;
  }

  double squares(const FourBar& linkage) const {
    const Motion motion(linkage);
    double sum = 0;
    for (std::size_t i = 0; i < angles.size(); ++i) {
      const auto pose = motion.at(angles[i]);
      if (!pose) return INFINITY;
      sum += squared_norm(*pose->coupler_point - problem.points[i]);
    }
    return sum;
  }

  GridSearch() {
    planted = {{0, 0}, {2, 0.5}, 0.7, 2.1, 1.8, Assembly::open, Vec2d{1.2, 0.9}};
    problem.timing = Timing::prescribed;
    problem.crank_reference = CrankReference::global;
    problem.crank_angles = angles;
    for (const double angle : angles) {
      problem.points.push_back(*Motion(planted).at(angle)->coupler_point);
    }
    problem.given.pivot_a = planted.pivot_a;
    problem.given.pivot_d = planted.pivot_d;
    problem.given.crank = planted.crank;
    problem.given.assembly = planted.assembly;
    problem.weights.assign(angles.size(), 1.0);
    problem.constraints.required_class = RequiredClass::crank_rocker;
    problem.solve.starts = 25;
    problem.solve.designs = 1;
  }

  /// The greatest x of the planted coupler point.
  double furthest() const {
    const Box far{{-100, -100}, {50, 100}};
    return 50 - clearance_distance(planted, {MovingPoint::coupler_point, true, far});
  }

  /// Solves, and expects the grid's best, `limited` being at its bound.
  void expect(double wanted, const std::string& limited) const {
    const Result result = solve(problem, {.threads = 2});
    ASSERT_EQ(result.status, Status::solved) << "of the grid: " << wanted;
    const Design& design = result.designs.front();
    EXPECT_LT(design.error.sum_of_squares, wanted * (1 + 1e-6));
    EXPECT_GT(design.error.sum_of_squares, wanted * (1 - 1e-3));
    EXPECT_GT(wanted, 1e-4);  // the planted design violates the limit
    for (const ConstraintCheck& check : design.constraints) {
      EXPECT_TRUE(check.satisfied) << check.name;
      if (check.name != limited) continue;
      const double value = std::get<double>(check.value), bound = std::get<double>(check.bound);
      EXPECT_NEAR(value, bound, 1e-7 * (1 + std::abs(bound)));
    }
  }
};

const auto set_point = [](FourBar& linkage, const Vec2d& at) { linkage.coupler_point = at; };
const auto set_lengths = [](FourBar& linkage, const Vec2d& at) {
  linkage.coupler = at.x;
  linkage.rocker = at.y;
};

/// The best coupler point under a clearance that the planted linkage breaks.
void expect_best_point(GridSearch& grid, const Clearance& clearance) {
  ASSERT_LT(clearance_distance(grid.planted, clearance), -0.05);
  grid.problem.constraints.clearances = {clearance};
  grid.problem.given.coupler = grid.planted.coupler;
  grid.problem.given.rocker = grid.planted.rocker;
  const double best = grid.best(
      set_point, [&](const FourBar& l) { return clearance_distance(l, clearance) >= 0; },
      {1.2, 0.9}, 0.8);
  grid.expect(best, "clearance[1]");
}

TEST(CycleOptima, TheBestPointInsideABoxIsThatOfAGrid) {
  GridSearch grid;
  expect_best_point(grid,
                    {MovingPoint::coupler_point, true, {{-3, -3}, {grid.furthest() - 0.2, 3}}});
}

TEST(CycleOptima, TheBestPointBesideAnObstacleIsThatOfAGrid) {
  GridSearch grid;
  expect_best_point(grid,
                    {MovingPoint::coupler_point, false, {{grid.furthest() - 0.2, -1}, {4, 4}}});
}

/// The best coupler and rocker with a share of what a quantity of the planted linkage is.
void expect_best_links(CycleQuantity quantity, double share) {
  GridSearch grid;
  grid.problem.given.coupler_point = grid.planted.coupler_point;
  grid.problem.constraints.operation = machine();
  const auto value = [&](const FourBar& linkage) {
    return cycle_metric(quantity, linkage, CycleOutput::coupler_point, machine());
  };
  const double most = share * value(grid.planted);
  grid.problem.constraints.cycle_max[quantity] = most;
  const double best = grid.best(
      set_lengths, [&](const FourBar& l) { return value(l) <= most; }, {2.1, 1.8}, 0.6);
  grid.expect(best, std::string(kCycleQuantities.at(index_of(quantity)).limit_key));
}

TEST(CycleOptima, TheSlowestLinksAreThoseOfAGrid) {
  expect_best_links(CycleQuantity::peak_speed, 0.97);
}

TEST(CycleOptima, TheCalmestLinksAreThoseOfAGrid) {
  expect_best_links(CycleQuantity::peak_acceleration, 0.97);
}

TEST(CycleOptima, TheEvenestTorqueIsThatOfAGrid) {
  expect_best_links(CycleQuantity::torque_ripple, 0.85);
}

TEST(CycleOptima, TheLightestMotorIsThatOfAGrid) {
  expect_best_links(CycleQuantity::rms_torque, 0.95);
  expect_best_links(CycleQuantity::peak_torque, 0.95);
}

/// Coupler and rocker of a function generator are free, all else given.
TEST(CycleOptima, TheCalmestGeneratorIsThatOfAGrid) {
  const FourBar planted{{0, 0}, {2.6, 0}, 1, 2.2, 1.9, Assembly::open, std::nullopt};
  const auto angle = [](const FourBar& linkage, double at) {
    return Motion(linkage).at(at)->rocker_angle;
  };
  FunctionProblem problem;
  AnglePairs pairs;
  const double start = 0.4;
  for (const double input : {0.0, 0.5, 1.1, 1.8, 2.4}) {
    pairs.emplace_back(input, angle(planted, start + input) - angle(planted, start));
  }
  problem.target = pairs;
  problem.given.crank = planted.crank;
  problem.given.frame = planted.pivot_d.x;
  problem.given.assembly = planted.assembly;
  problem.input_start = start;
  problem.output_start = angle(planted, start);
  problem.constraints.required_class = RequiredClass::crank_rocker;
  const double most = 0.8 * peak_acceleration(planted, CycleOutput::rocker, 1);
  problem.constraints.cycle_max[CycleQuantity::peak_acceleration] = most;
  problem.solve.starts = 40;
  problem.solve.designs = 1;

  double best = INFINITY;
  Vec2d middle{planted.coupler, planted.rocker};
  double reach = 0.8;
  for (int round = 0; round < 16; ++round, reach *= 0.5) {
    Vec2d found = middle;
    for (int i = -12; i <= 12; ++i) {
      for (int j = -12; j <= 12; ++j) {
        const Vec2d at = middle + (reach / 12) * Vec2d{double(i), double(j)};
        FourBar linkage = planted;
        set_lengths(linkage, at);
        if (mobility_class(lengths(linkage)) != MobilityClass::crank_rocker) continue;
        double error = 0;
        for (const auto& [input, output] : pairs) {
          const double turned = angle(linkage, start + input) - *problem.output_start;
          error += std::pow(std::remainder(turned - output, kTurn), 2);
        }
        if (error >= best || peak_acceleration(linkage, CycleOutput::rocker, 1) > most) continue;
        best = error;
        found = at;
      }
    }
    middle = found;
  }
  const Result result = solve(problem, {.threads = 2});
  ASSERT_EQ(result.status, Status::solved) << "of the grid: " << best;
  const Design& design = result.designs.front();
  EXPECT_GT(best, 1e-5);
  EXPECT_LT(design.error.sum_of_squares, best * (1 + 1e-6));
  EXPECT_GT(design.error.sum_of_squares, best * (1 - 1e-3));
  EXPECT_NEAR(design.metrics.cycle[CycleQuantity::peak_acceleration].value(), most, 1e-7 * most);
}

/// Of a body's guidance the crank's length alone is free.
TEST(CycleOptima, TheCalmestGuidanceIsThatOfAScan) {
  const FourBar planted{{0, 0}, {2, 0.5}, 0.7, 2.1, 1.8, Assembly::open, Vec2d{1.2, 0.9}};
  MotionProblem problem;
  problem.method = MotionMethod::least_squares;
  problem.dyads = {synthesis::DyadKind::rr};
  for (const double angle : {0.3, 0.9, 1.6, 2.5, 3.9}) {
    const Pose pose = *Motion(planted).at(angle);
    const Vec2d along = pose.c - pose.b;
    problem.poses.push_back({*pose.coupler_point, std::atan2(along.y, along.x)});
  }
  const Vec2d b = -*planted.coupler_point;
  problem.fixed_pivots = {planted.pivot_a, planted.pivot_d};
  problem.moving_pivots = {b, b + Vec2d{planted.coupler, 0}};
  problem.rocker = planted.rocker;
  problem.constraints.required_class = RequiredClass::crank_rocker;
  const double most = 0.9 * peak_acceleration(planted, CycleOutput::coupler_point, 1);
  problem.constraints.cycle_max[CycleQuantity::peak_acceleration] = most;
  problem.solve.starts = 40;
  problem.solve.designs = 1;

  double low = 0.3, high = planted.crank;  // a shorter crank moves the body less
  for (int step = 0; step < 60; ++step) {
    FourBar linkage = planted;
    linkage.crank = 0.5 * (low + high);
    const bool calm = peak_acceleration(linkage, CycleOutput::coupler_point, 1) <= most;
    (calm ? low : high) = linkage.crank;
  }
  const Result result = solve(problem, {.threads = 2});
  ASSERT_EQ(result.status, Status::solved);
  EXPECT_NEAR(four_bar(result.designs.front()).crank, low, 1e-6);
  EXPECT_NEAR(result.designs.front().metrics.cycle[CycleQuantity::peak_acceleration].value(), most,
              1e-7 * most);
}

}  // namespace
}  // namespace cognate::problems::cycle_optima_test
