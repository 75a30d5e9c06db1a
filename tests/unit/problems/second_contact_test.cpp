/// Form-closed cams: the second contact touches too.
#include "problems/cam/second_contact.hpp"

#include <gtest/gtest.h>

#include "analysis/cam/profile.hpp"
#include "analysis/cam/turn_extremes.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/cam/quantities.hpp"
#include "problems/linkage/verify.hpp"
#include "tests/support/cam_problems.hpp"

namespace cognate::second_contact_test {
namespace {

using cam::Cam;
using cam::Closure;
using cam::MotionLaw;
using problems::CamDimension;
using problems::CamProblem;
using problems::Status;

std::vector<cam::ProfilePoint> profile(const Cam& cam) {
  return cam::polygon({cam.system, cam.programme, -cam.system.follower.dimensions.roller_radius},
                      1e-7);
}

double distance(const Vec2d& p, const std::vector<cam::ProfilePoint>& polygon) {
  double least = HUGE_VAL;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2d a = polygon[i].at, ab = polygon[(i + 1) % polygon.size()].at - a;
    const double t = std::clamp(dot(p - a, ab) / squared_norm(ab), 0.0, 1.0);
    least = std::min(least, norm(p - a - t * ab));
  }
  return least;
}

Vec2d turned(const Vec2d& p, double angle) {
  return p * Vec2d{std::cos(angle), std::sin(angle)};
}

// Two rollers at a fixed distance on one stem, each on its own cam of one shaft.
TEST(SecondContact, ConjugateCamTouchesTheSecondRollerOfAStem) {
  std::mt19937_64 random(31);
  for (const std::optional<double> breadth : {std::optional<double>{}, std::optional(130.0)}) {
    CamProblem problem = translating_roller(50, 6, 7);
    problem.motion = random_motion(random, 12);
    problem.second = {Closure::conjugate, breadth, {}};
    const auto design = solve(problem, {.threads = 1}).designs.at(0);
    ASSERT_TRUE(design.second);
    const auto curve = profile(*design.second);
    const double start = std::sqrt(50.0 * 50 - 36);
    const double apart = breadth.value_or(2 * start + 12);
    for (int degree = 0; degree < 360; degree += 9) {
      const double angle = degree * kDegree;
      const double height = start + design.cam.programme.at(angle).displacement;
      const Vec2d lower{6, height - apart};
      // The second cam is given upright: mounted, it is turned by half a turn.
      const Vec2d seen = turned(lower, -angle - kPi);
      EXPECT_NEAR(distance(seen, curve), 7, 1e-6) << degree;
    }
  }
}

TEST(SecondContact, ConjugateCamTouchesTheSecondRollerOfAnArm) {
  std::mt19937_64 random(32);
  CamProblem problem = oscillating_roller(40, 80, 60, 6);
  problem.motion = random_motion(random, 10 * kDegree);
  problem.second = {Closure::conjugate, {}, 70 * kDegree};
  const auto design = solve(problem, {.threads = 1}).designs.at(0);
  ASSERT_TRUE(design.second);
  const auto curve = profile(*design.second);
  for (int degree = 0; degree < 360; degree += 9) {
    const double angle = degree * kDegree;
    const double first = design.cam.system.start + design.cam.programme.at(angle).displacement;
    const double other = 70 * kDegree - first;  // on the other side of the line of centres
    const Vec2d roller{60 * std::sin(other), 80 - 60 * std::cos(other)};
    EXPECT_NEAR(distance(turned(roller, -angle), curve), 6, 1e-6) << degree;
  }
}

// What the second cam must give is what the first would have to hold back, at every position.
TEST(SecondContact, ConjugateCamsShareTheDemand) {
  std::mt19937_64 random(33);
  CamProblem problem = translating_roller(0.05, 0.006, 0.007);
  problem.motion = random_motion(random, 0.012);
  problem.operation = {0.4, 50, 3000, 60, 15, 0.01, 8e-12};
  problem.preload = 60;
  problem.has_operation = problem.has_contact = true;
  problem.second.closure = Closure::conjugate;
  const auto design = solve(problem, {.threads = 1}).designs.at(0);
  ASSERT_TRUE(design.second);
  for (int degree = 0; degree < 360; degree += 13) {
    const auto demanded = [&](const Cam& cam) {
      return value_of(cam::CamQuantity::demand, cam.system, cam.programme.at(degree * kDegree));
    };
    const double first = demanded(design.cam);
    EXPECT_NEAR(demanded(*design.second), -first, 1e-12 * 300) << degree;
  }
}

CamProblem yoke(cam::FollowerType type) {
  CamProblem problem;
  problem.follower = type;
  use(problem, CamDimension::base_radius, 70);
  use(problem, CamDimension::offset, 0);
  if (!is_flat(type)) use(problem, CamDimension::roller_radius, 8);
  problem.second.closure = Closure::constant_breadth;
  problem.motion = {segment(MotionLaw::dwell, 60), segment(MotionLaw::cycloidal, 120, 12),
                    segment(MotionLaw::dwell, 60), segment(MotionLaw::cycloidal, 120, -12)};
  return problem;
}

// The width of the profile square to every direction is the breadth.
TEST(SecondContact, ConstantBreadthIsConstant) {
  const auto result = solve(yoke(cam::FollowerType::translating_flat), {.threads = 1});
  ASSERT_EQ(result.status, Status::solved);
  const Cam& cam = result.designs[0].cam;
  EXPECT_NEAR(problems::constant_breadth(cam), 152, 1e-12);
  const auto curve = profile(cam);
  for (int degree = 0; degree < 180; degree += 7) {
    const Vec2d direction = turned({1, 0}, degree * kDegree);
    double least = HUGE_VAL, greatest = -HUGE_VAL;
    for (const auto& point : curve) {
      least = std::min(least, dot(direction, point.at));
      greatest = std::max(greatest, dot(direction, point.at));
    }
    EXPECT_NEAR(greatest - least, 152, 1e-6) << degree;
  }
}

TEST(SecondContact, MotionsWithoutConstantBreadthAreNamed) {
  CamProblem problem = yoke(cam::FollowerType::translating_roller);
  problem.motion[1].law = MotionLaw::harmonic;
  const auto result = solve(problem, {.threads = 1});
  EXPECT_EQ(result.status, Status::no_solution);
  // What harmonic and cycloidal motion differ by at most, on a grid.
  double farthest = 0;
  for (int i = 0; i <= 100000; ++i) {
    const double u = i / 1e5, pi = kPi;
    const double harmonic = 6 * (1 - std::cos(pi * u));
    const double cycloidal = 12 * (u - std::sin(2 * pi * u) / (2 * pi));
    farthest = std::max(farthest, std::abs(harmonic - cycloidal));
  }
  const auto fault = problems::breadth_fault(*programme_of(problem.motion));
  EXPECT_NEAR(std::abs(fault.deviation), farthest, 1e-8);
  ASSERT_FALSE(result.notes.empty());
  EXPECT_NE(result.notes[0].find("s(δ) + s(δ + 180°)"), std::string::npos);
}

// A groove's outer wall is undercut where the pitch curve is more hollow than the roller.
TEST(SecondContact, OuterWallOfAGroove) {
  CamProblem problem = translating_roller(30, 0, 4);
  problem.second.closure = Closure::groove;
  problem.motion = {segment(MotionLaw::cycloidal, 60, 25), segment(MotionLaw::cycloidal, 60, -25),
                    segment(MotionLaw::dwell, 240)};
  auto design = solve(problem, {.threads = 1}).designs.at(0);
  const double hollow =
      -1 / cam::turn_extremes(design.cam.programme, cam::MotionPart::whole, design.cam.system,
                              cam::CamQuantity::pitch_curvature)
               ->least.value;
  for (const double share : {0.98, 1.02}) {
    problem.length(CamDimension::roller_radius).given = share * hollow;
    problem.constraints.curvature_radius_min = 0.0;
    design = solve(problem, {.threads = 1}).designs.at(0);
    const auto& checks = design.constraints;
    const auto wall =
        std::ranges::find(checks, "no_undercut.outer_wall", &problems::ConstraintCheck::name);
    ASSERT_NE(wall, checks.end());
    EXPECT_EQ(wall->satisfied, share < 1);
  }
}

}  // namespace
}  // namespace cognate::second_contact_test
