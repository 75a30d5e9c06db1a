/// Cams at the edge of what there is: hardly any rise, offsets as large as the cam, rollers as
/// large as its least radius, cusps, very many segments, any size.
#include <gtest/gtest.h>

#include "analysis/numbers/constants.hpp"
#include "problems/cam/extremes.hpp"
#include "problems/linkage/verify.hpp"
#include "tests/support/cam_problems.hpp"

namespace cognate {
namespace {

using cam::MotionLaw;
using problems::CamDimension;
using problems::CamProblem;
using problems::Status;

std::vector<cam::MotionSegment> rise_and_return(MotionLaw law, double stroke) {
  return {segment(law, 100, stroke), segment(MotionLaw::dwell, 50), segment(law, 120, -stroke),
          segment(MotionLaw::dwell, 90)};
}

void expect_finite(const problems::CamResult& result) {
  for (const auto& design : result.designs) {
    for (const auto& quantity : design.metrics) {
      const auto* number = std::get_if<double>(&quantity.value);
      EXPECT_TRUE(!number || std::isfinite(*number)) << quantity.name;
    }
  }
}

// As the rise goes to zero, the smallest cam shrinks in proportion, to the last digits.
TEST(CamStress, RisesToZero) {
  const auto radius = [](double stroke) {
    CamProblem problem = translating_roller({}, {}, stroke * 1e-3);
    problem.motion = rise_and_return(MotionLaw::modified_sine, stroke);
    problem.constraints.pressure_angle_max_rise = 0.5;
    problem.constraints.pressure_angle_max_return = 0.7;
    problem.constraints.curvature_radius_min.reset();
    const auto result = solve(problem, {.threads = 1});
    EXPECT_EQ(result.status, Status::solved) << stroke;
    expect_finite(result);
    return result.designs.at(0).cam.system.follower.dimensions.base_radius;
  };
  const double of_one = radius(1);
  for (const double stroke : {1e-3, 1e-6, 1e-9, 1e-12, 1e-20, 1e20}) {
    EXPECT_NEAR(radius(stroke) / stroke, of_one, 1e-13 * of_one) << stroke;
  }
}

// A rise far smaller than the cam changes the pressure angle by s′/r₀ to first order.
TEST(CamStress, SmallRisesOnLargeCams) {
  for (const double stroke : {1e-3, 1e-6, 1e-9}) {
    CamProblem problem = translating_roller(100, 0, 5);
    problem.motion = rise_and_return(MotionLaw::cycloidal, stroke);
    const auto result = solve(problem, {.threads = 1});
    expect_finite(result);
    const auto rise =
        problems::CamExtremes(result.designs.at(0).cam).pressure_angle(cam::MotionPart::rises);
    EXPECT_NEAR(rise->value, 2 * stroke / (100 * kDegree) / 100, 1.1 * stroke / 100 * rise->value)
        << stroke;
  }
}

// Offsets up to the base radius: s₀ = √((r₀ − e)(r₀ + e)) keeps its digits, the angle stays right.
TEST(CamStress, OffsetsAsLargeAsTheCam) {
  for (const double missing : {1e-1, 1e-4, 1e-8, 1e-12}) {
    CamProblem problem = translating_roller(50, 50 * (1 - missing), 1);
    problem.motion = rise_and_return(MotionLaw::cycloidal, 10);
    const auto result = solve(problem, {.threads = 1});
    expect_finite(result);
    const auto& cam = result.designs.at(0).cam;
    const double still =
        value_of(cam::CamQuantity::pressure_angle, cam.system, cam.programme.at(0));
    const double offset = 50 * (1 - missing);
    const double left = (50 - offset) / 50;  // exact
    const double start = 50 * std::sqrt(left * (2 - left));
    EXPECT_NEAR(std::tan(-still) * start, offset, 1e-14 * 50 * (1 + 50 / start)) << missing;
    EXPECT_GE(problems::CamExtremes(cam).pressure_angle().value, -still);
  }
}

// A roller as large as the pitch curve's least radius: a cusp; the facts flip from sound to
// undercut within rounding of it.
TEST(CamStress, RollersAsLargeAsTheLeastRadius) {
  CamProblem problem = translating_roller(30, 4, 1);
  problem.motion = rise_and_return(MotionLaw::harmonic, 10);  // least where the rise ends
  problem.constraints.curvature_radius_min.reset();
  const double least = problems::CamExtremes(solve(problem, {.threads = 1}).designs.at(0).cam)
                           .convex_radius()
                           ->value +
                       1;
  ASSERT_LT(least, 29);
  for (const double share : {1 - 1e-6, 1 - 1e-12, 1.0, 1 + 1e-12, 1 + 1e-6}) {
    problem.length(CamDimension::roller_radius).given = share * least;
    const auto result = solve(problem, {.threads = 1});
    expect_finite(result);
    const double left = problems::CamExtremes(result.designs.at(0).cam).convex_radius()->value;
    EXPECT_NEAR(left, (1 - share) * least, 1e-14 * least) << share;
  }
}

// Motions with corners and with endless curvature: constant velocity, and a knife edge on them.
TEST(CamStress, CornersAndCusps) {
  for (const auto follower :
       {cam::FollowerType::translating_roller, cam::FollowerType::translating_knife,
        cam::FollowerType::translating_flat}) {
    CamProblem problem = translating_roller(20, 5, 3);
    problem.follower = follower;
    if (follower != cam::FollowerType::translating_roller) {
      problem.length(CamDimension::roller_radius) = {};
    }
    for (const double over : {90.0, 1.0, 1e-3}) {
      problem.motion = {segment(MotionLaw::constant_velocity, over, 15),
                        segment(MotionLaw::constant_velocity, over, -15),
                        segment(MotionLaw::dwell, 360 - 2 * over)};
      const auto result = solve(problem, {.threads = 1});
      expect_finite(result);
      ASSERT_EQ(result.designs.size(), 1U);
      const bool named =
          std::ranges::any_of(result.jumps, [](const cam::Jump& jump) { return jump.order == 1; });
      EXPECT_TRUE(named) << over;
    }
  }
}

// An arm's edge follows corners of constant velocity, outward and hollow.
TEST(CamStress, CornersUnderASwingingEdge) {
  for (const double over : {90.0, 10.0}) {
    CamProblem problem = oscillating_roller(40, 80, 60, 0);
    problem.follower = cam::FollowerType::oscillating_knife;
    problem.motion = {segment(MotionLaw::constant_velocity, over, 0.05),
                      segment(MotionLaw::constant_velocity, over, -0.05),
                      segment(MotionLaw::dwell, 360 - 2 * over)};
    const auto result = solve(problem, {.threads = 1});
    expect_finite(result);
    ASSERT_EQ(result.designs.size(), 1U);
    EXPECT_EQ(result.status, problems::Status::solved) << over;
  }
}

// Many short waves: each is a scaled copy of one, so are the extremes.
TEST(CamStress, ManySegments) {
  constexpr int kWaves = 5'000;
  CamProblem problem = translating_roller(100, 0, 1e-9);
  problem.constraints.curvature_radius_min.reset();
  for (int i = 0; i < kWaves; ++i) {
    problem.motion.push_back(segment(MotionLaw::cycloidal, 180.0 / kWaves, 1e-3));
    problem.motion.push_back(segment(MotionLaw::cycloidal, 180.0 / kWaves, -1e-3));
  }
  const auto result = solve(problem, {.threads = 1});
  expect_finite(result);
  const auto& cam = result.designs.at(0).cam;
  const double steepest = 2 * 1e-3 / (kPi / kWaves);
  const auto rise = problems::CamExtremes(cam).pressure_angle(cam::MotionPart::rises);
  // At the steepest place, half way up, or near it where the height is less.
  EXPECT_NEAR(std::tan(rise->value) * (100 + 5e-4), steepest, 1e-6 * steepest);
}

// The same cam a million times as large, or as small, is the same cam.
TEST(CamStress, AnySize) {
  std::mt19937_64 random(41);
  const auto motion = random_motion(random, 1);
  const auto radius = [&](double size) {
    CamProblem problem = translating_roller({}, {}, 0.3 * size);
    problem.motion = motion;
    for (auto& one : problem.motion) one.rise *= size;
    problem.constraints.pressure_angle_max = 0.5;
    problem.constraints.curvature_radius_min = 0.8 * size;
    const auto result = solve(problem, {.threads = 1});
    EXPECT_EQ(result.status, Status::solved) << size;
    return result.designs.at(0).cam.system.follower.dimensions.base_radius / size;
  };
  const double of_one = radius(1);
  for (const double size : {1e-6, 1e6, 1e-15, 1e15}) {
    EXPECT_NEAR(radius(size), of_one, 1e-8 * of_one) << size;
  }
}

}  // namespace
}  // namespace cognate
