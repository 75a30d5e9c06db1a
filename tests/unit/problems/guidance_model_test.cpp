/// The motion model: exact derivatives, and the mechanism that its variables stand for.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "analysis/mechanism/kinematics.hpp"
#include "analysis/numbers/angle.hpp"
#include "problems/guidance/dead_station.hpp"
#include "problems/guidance/model.hpp"
#include "synthesis/exact/motion/guided_mechanism.hpp"
#include "synthesis/optimise/check_derivatives.hpp"

namespace cognate::problems::guidance_model_test {
namespace {

using synthesis::DyadKind;
using synthesis::GuidingDyad;
using synthesis::Pose;

GuidingDyad link(const Vec2d& in_body, const Vec2d& fixed, double length) {
  return {DyadKind::rr, in_body, {}, fixed, {1, 0}, length};
}

/// Two dyads, and crank angles at which they close.
struct Planted {
  std::string name;
  DyadPair pair;
};

std::vector<Planted> planted() {
  const GuidingDyad crank = link({-0.4, 0.3}, {0.2, -0.3}, 0.8);
  const Vec2d line{std::cos(0.4), std::sin(0.4)};
  const GuidingDyad slider{DyadKind::pr, {1.9, 0.4}, {}, {0.3, -0.2}, line};
  const GuidingDyad block{DyadKind::rp, {0.1, -0.2}, {}, {2.5, 0.7}, line};
  return {{"RR", {crank, link({1.3, 0.6}, {2.1, 0.9}, 1.6)}},
          {"PR", {crank, slider}},
          {"RP", {crank, block}}};
}

/// Poses through which the kernel takes the body of `pair`.
std::vector<Pose> kernel_poses(const DyadPair& pair, const std::vector<double>& cranks) {
  // The first dyad's pin at the first angle; the body turned by a guess that the kernel closes.
  const std::vector<Pose> any{{{0, 0}, 0.1}};
  const auto guided = synthesis::guided_mechanism(pair.first, pair.second, any);
  MechanismMotion<0> motion(guided.chain);
  std::vector<Pose> poses;
  for (const double crank : cranks) {
    EXPECT_TRUE(motion.move_to(crank));
    const auto& body = motion.bodies()[static_cast<std::size_t>(guided.body)];
    poses.push_back({body.origin[0] + body.direction * guided.body_in_link.at,
                     std::atan2(body.direction.y, body.direction.x) + guided.body_in_link.angle});
  }
  return poses;
}

MotionProblem problem_of(const DyadPair& pair) {
  MotionProblem problem;
  problem.method = MotionMethod::least_squares;
  problem.poses = kernel_poses(pair, {0.3, 0.8, 1.3, 1.9, 2.4, 2.9});
  problem.angle_weight = 0.7;
  problem.dyads = {DyadKind::rr, DyadKind::pr, DyadKind::rp};
  return problem;
}

TEST(MotionModel, HasNoResidualWhereTheKernelTakesTheBody) {
  for (const auto& [name, pair] : planted()) {
    SCOPED_TRACE(name);
    const MotionProblem problem = problem_of(pair);
    const MotionModel model(problem, form_of(problem, pair));
    const auto x = model.variables_of(pair);
    std::vector<double> r(static_cast<std::size_t>(model.residual_count()));
    ASSERT_TRUE(model.residuals(x, r, {}, {}));
    for (const double value : r) EXPECT_NEAR(value, 0, 1e-13);

    const DyadPair back = model.pair(x);
    EXPECT_NEAR(norm(back.first.in_body - pair.first.in_body), 0, 1e-14);
    EXPECT_NEAR(synthesis::guidance_residual(back.second, problem.poses), 0, 1e-12);
    EXPECT_EQ(back.second.kind, pair.second.kind);
    const auto reached = model.reached(x);
    ASSERT_EQ(reached.size(), problem.poses.size());
    for (std::size_t j = 0; j < reached.size(); ++j) {
      EXPECT_NEAR(norm(reached[j].at - problem.poses[j].at), 0, 1e-13);
    }
  }
}

std::vector<MotionProblem> variants(const DyadPair& pair) {
  MotionProblem free = problem_of(pair), bounded = free, given = free;
  bounded.constraints.required_class = RequiredClass::crank_rocker;
  bounded.constraints.transmission_angle = Range{0.5, 2.4};
  bounded.constraints.link_ratio_max = 5;
  bounded.bounds.coupler = Range{0.5, 4};
  bounded.bounds.frame = Range{0.5, 4};
  given.fixed_pivots = {pair.first.fixed};
  given.moving_pivots = {pair.first.in_body};
  given.crank = pair.first.length;
  return {free, bounded, given};
}

TEST(MotionModel, HasExactDerivatives) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> disturbance(-0.04, 0.04);
  for (const auto& [name, pair] : planted()) {
    int number = 0;
    for (const MotionProblem& problem : variants(pair)) {
      SCOPED_TRACE(name + " " + std::to_string(number++));
      const MotionModel model(problem, form_of(problem, pair));
      auto x = model.variables_of(pair);
      for (double& value : x) value += disturbance(random);
      const auto error = synthesis::check_derivatives(model, x);
      ASSERT_TRUE(error.has_value);
      EXPECT_LT(error.relative, 1e-7) << error.describe(model);
    }
  }
}

TEST(MotionModel, HasExactDerivativesByTheEndsOfALimitedMotion) {
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> disturbance(-0.04, 0.04);
  const DyadPair pair = planted().front().pair;
  int rows = 0;
  for (const bool backward : {false, true}) {
    MotionProblem problem = problem_of(pair);
    if (backward) std::ranges::reverse(problem.poses);
    problem.constraints.required_class = RequiredClass::triple_rocker;
    problem.constraints.transmission_angle = Range{0.5, 2.4};
    MotionForm form = form_of(problem, pair);
    const MotionModel free(problem, form);
    auto angles = free.station_angles(free.variables_of(pair));
    EXPECT_EQ(free.global_count(), 10);
    form.stations = {0, 1, 1, 2, 3, 4};
    angles.erase(angles.begin() + 2);
    const MotionModel model(problem, form);
    EXPECT_EQ(model.global_count(), 12);
    EXPECT_EQ(model.local_count(), 3);
    EXPECT_EQ(model.constraint_count(), free.constraint_count() + 2);
    auto x = model.with_angles(free.variables_of(pair), angles);
    for (double& value : x) value += disturbance(random);
    const auto error = synthesis::check_derivatives(model, x);
    ASSERT_TRUE(error.has_value);
    EXPECT_LT(error.relative, 1e-7) << error.describe(model);
    rows += model.constraint_count();
  }
  EXPECT_GE(rows, 4);
}

/// Coupler √3.0, frame √5.05, crank 0.8: with this rocker the four-bar has a dead point stretched,
/// and with a short one a folded one.
DyadPair with_dead_points(double rocker) {
  return {link({-0.4, 0.3}, {0.2, -0.3}, 0.8), link({1.3, 0.6}, {2.1, 0.9}, rocker)};
}

struct HeldCase {
  double rocker, side;
  HeldDeadPoint at;
};

std::vector<HeldCase> held_cases() {
  std::vector<HeldCase> cases;
  for (const double side : {1.0, -1.0}) {
    for (const bool left : {true, false}) {
      for (const double rocker : {1.0, 0.2}) {
        cases.push_back({rocker, side, {.stretched = true, .left = left}});
      }
      cases.push_back({0.2, side, {.stretched = false, .left = left}});
    }
  }
  return cases;
}

TEST(MotionModel, HoldsStationsBesideDeadPointsOfTheLinkage) {
  for (const auto& [rocker, side, at] : held_cases()) {
    SCOPED_TRACE(testing::Message() << rocker << ' ' << side << ' ' << at.stretched << at.left);
    const DyadPair pair = with_dead_points(rocker);
    const Vec2d a = pair.first.fixed, d = pair.second.fixed;
    const Vec2d m = pair.second.in_body - pair.first.in_body;
    const std::array<double, 10> v{-0.4, 0.3, a.x, a.y, 0.8, 1.3, 0.6, d.x, d.y, rocker};
    const auto station = dead_station(v, at, side);
    ASSERT_TRUE(station);
    const Vec2d far = station->pin + station->turn * m;
    EXPECT_NEAR(norm(station->pin - a), 0.8, 1e-14);
    EXPECT_NEAR(norm(far - d), rocker, 1e-14);
    const Vec2d coupler = station->pin - far, link = d - far;
    const double angle = std::atan2(std::abs(cross(coupler, link)), dot(coupler, link));
    EXPECT_NEAR(at.stretched ? std::numbers::pi - angle : angle, kHeldFromDead, 1e-11);
    EXPECT_GT(side * cross(station->pin - d, far - station->pin), 0);
    EXPECT_EQ(cross(d - a, station->pin - a) > 0, at.left);
    EXPECT_EQ(nearest_dead_point(v, station->pin), at);

    // The pin hardly moves where the linkage leaves the dead point.
    constexpr double kStep = 1e-6;
    const auto next = dead_station(v, at, side, kHeldFromDead + kStep);
    ASSERT_TRUE(next);
    const double turned = angle_of(next->turn * conj(station->turn)) / kStep;
    EXPECT_NEAR(turned, turn_leaving(v, at, side), 1e-3 * std::abs(turned));
  }
}

TEST(MotionModel, HasExactDerivativesWhereStationsAreHeld) {
  for (const auto& [rocker, side, at] : held_cases()) {
    SCOPED_TRACE(testing::Message() << rocker << ' ' << side << ' ' << at.stretched << at.left);
    const DyadPair pair = with_dead_points(rocker);
    MotionProblem problem = problem_of(planted().front().pair);
    MotionForm form = form_of(problem, pair);
    form.sides.assign(problem.poses.size(), side);
    const auto free = MotionModel(problem, form).variables_of(pair);
    form.stations = {0, 1, 1, 2, 3, 4};
    form.held.resize(5);
    form.held[1] = form.held[4] = at;
    form.closes_towards = form.closes_away = true;
    const MotionModel model(problem, form);
    EXPECT_EQ(model.local_count(), 3);
    const auto x = model.with_angles(free, std::vector{free[10], 0.0, free[13], free[14], 0.0});
    const auto error = synthesis::check_derivatives(model, x);
    ASSERT_TRUE(error.has_value);
    EXPECT_LT(error.relative, 1e-6) << error.describe(model);

    const auto reached = model.reached(x);
    ASSERT_EQ(reached.size(), 6U);
    EXPECT_EQ(reached[1].at.x, reached[2].at.x);
    const auto angles = model.station_angles(x);
    EXPECT_EQ(angles[1], angles[4]);
  }
}

TEST(MotionModel, IsKeptClosedWhereTheLinkageClosesInLineWithTheFrame) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> place(-2, 2), length(0.3, 2.5);
  const auto any = [&] { return Vec2d{place(random), place(random)}; };
  int closed = 0, open = 0;
  for (int number = 0; number < 300; ++number) {
    const DyadPair pair{link(any(), any(), length(random)), link(any(), any(), length(random))};
    const MotionProblem problem = problem_of(planted().front().pair);
    for (const bool towards : {true, false}) {
      MotionForm form = form_of(problem, pair);
      (towards ? form.closes_towards : form.closes_away) = true;
      const MotionModel model(problem, form);
      const auto x = model.variables_of(pair);
      std::vector<double> c(static_cast<std::size_t>(model.constraint_count()));
      model.constraints(x, c, {});
      const Vec2d frame = pair.second.fixed - pair.first.fixed;
      const double line = angle_of(towards ? frame : -frame);
      const auto closes = [&](double angle) { return model.body_at(x, angle).has_value(); };
      bool somewhere = false;
      for (int k = 0; k < 720; ++k) somewhere = somewhere || closes(std::numbers::pi * k / 360);
      if (!somewhere) continue;
      EXPECT_EQ(c.back() > 0, closes(line)) << number << towards;
      ++(c.back() > 0 ? closed : open);
    }
  }
  EXPECT_GT(closed, 50);
  EXPECT_GT(open, 50);
}

TEST(MotionModel, LeavesOutWhatIsGiven) {
  const DyadPair pair = planted().front().pair;
  const auto all = variants(pair);
  const auto count = [&](const MotionProblem& problem) {
    return MotionModel(problem, form_of(problem, pair)).global_count();
  };
  EXPECT_EQ(count(all[0]), 10);
  EXPECT_EQ(count(all[2]), 5);
}

TEST(MotionModel, StartsWhereTheMechanismClosesNearestToThePose) {
  // The crank is too short to hold the body at the pose; a mechanism is found beside it.
  DyadPair pair = planted().front().pair;
  const MotionProblem problem = problem_of(pair);
  pair.second.length = 0.9;
  const MotionModel model(problem, form_of(problem, pair));
  std::vector<double> r(static_cast<std::size_t>(model.residual_count()));
  EXPECT_TRUE(model.residuals(model.variables_of(pair), r, {}, {}));
}

TEST(MotionModel, KeepsToOneSideWhereDefectsAreExcluded) {
  const DyadPair pair = planted().front().pair;
  MotionProblem problem = problem_of(pair);
  problem.poses[2].angle += 2.5;  // to the other side
  const auto is_one = [](const MotionForm& form) {
    return std::ranges::count(form.sides, form.sides[0]) == std::ssize(form.sides);
  };
  EXPECT_TRUE(is_one(form_of(problem, pair)));
  problem.constraints.no_branch_defect = problem.constraints.no_circuit_defect = false;
  EXPECT_FALSE(is_one(form_of(problem, pair)));
}

}  // namespace
}  // namespace cognate::problems::guidance_model_test
