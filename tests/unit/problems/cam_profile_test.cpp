/// The profile touches its follower in every position, by distances that know nothing of envelopes.
#include <gtest/gtest.h>

#include "analysis/cam/profile.hpp"
#include "problems/cam/extremes.hpp"
#include "tests/support/cam_problems.hpp"

namespace cognate::cam_profile_test {
namespace {

using cam::Cam;
using cam::CamCurve;
using cam::ProfilePoint;
using problems::CamDimension;
using problems::CamProblem;

Cam cam_of(const CamProblem& problem) {
  return solve(problem, {.threads = 1}).designs.at(0).cam;
}

double distance_to_segment(const Vec2d& p, const Vec2d& a, const Vec2d& b) {
  const Vec2d ab = b - a;
  const double t = std::clamp(dot(p - a, ab) / squared_norm(ab), 0.0, 1.0);
  return norm(p - a - t * ab);
}

double distance_to_polygon(const Vec2d& p, const std::vector<ProfilePoint>& polygon) {
  double least = HUGE_VAL;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    least = std::min(least,
                     distance_to_segment(p, polygon[i].at, polygon[(i + 1) % polygon.size()].at));
  }
  return least;
}

Vec2d turned(const Vec2d& p, double angle) {
  return p * Vec2d{std::cos(angle), std::sin(angle)};
}

/// Where the follower's roller centre stands in the frame, by trigonometry alone.
Vec2d roller_centre(const Cam& cam, double angle) {
  const auto& d = cam.system.follower.dimensions;
  const double s = cam.programme.at(angle).displacement;
  if (cam.system.follower.type == cam::FollowerType::oscillating_roller) {
    const double start = std::acos(
        (d.centre_distance * d.centre_distance + d.arm * d.arm - d.base_radius * d.base_radius) /
        (2 * d.centre_distance * d.arm));
    const double side = sign_of(cam.system.follower.side);
    return {-side * d.arm * std::sin(start + s), d.centre_distance - d.arm * std::cos(start + s)};
  }
  return {d.offset, std::sqrt(d.base_radius * d.base_radius - d.offset * d.offset) + s};
}

/// Signed distance of p from the face, positive on the follower's side.
double beyond_face(const Cam& cam, double angle, const Vec2d& p) {
  const auto& d = cam.system.follower.dimensions;
  const double s = cam.programme.at(angle).displacement;
  if (cam.system.follower.type == cam::FollowerType::translating_flat) {
    return p.y - d.base_radius - s;
  }
  const double swing = std::asin((d.base_radius + d.face_offset) / d.centre_distance) + s;
  const double side = sign_of(cam.system.follower.side);
  const Vec2d up{-side * std::cos(swing), std::sin(swing)};
  return dot(up, p - Vec2d{0, d.centre_distance}) + d.face_offset;
}

constexpr double kTolerance = 1e-7;

std::vector<ProfilePoint> profile(const Cam& cam) {
  const CamCurve curve{cam.system, cam.programme, -cam.system.follower.dimensions.roller_radius};
  return polygon(curve, kTolerance);
}

/// At every position the profile, turned with the cam, is as far from the roller's centre as its
/// radius is: it touches and nothing overlaps.
void expect_roller_touches(const Cam& cam) {
  const auto all = profile(cam);
  for (int degree = 0; degree < 360; degree += 7) {
    const double angle = degree * kDegree;
    const double gap = distance_to_polygon(turned(roller_centre(cam, angle), -angle), all) -
                       cam.system.follower.dimensions.roller_radius;
    EXPECT_NEAR(gap, 0, 2 * kTolerance) << degree;
  }
}

void expect_face_touches(const Cam& cam) {
  const auto all = profile(cam);
  for (int degree = 0; degree < 360; degree += 7) {
    const double angle = degree * kDegree;
    double farthest = -HUGE_VAL;
    for (const ProfilePoint& point : all) {
      farthest = std::max(farthest, beyond_face(cam, angle, turned(point.at, angle)));
    }
    EXPECT_NEAR(farthest, 0, 2 * kTolerance) << degree;
  }
}

TEST(CamProfile, TouchesTranslatingRollers) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> offset(-10, 10), roller(1, 12);
  for (int i = 0; i < 6; ++i) {
    CamProblem problem = translating_roller(60, offset(random), roller(random));
    problem.motion = random_motion(random, 20);
    const Cam cam = cam_of(problem);
    const auto sharpest = problems::CamExtremes(cam).convex_radius();
    if (sharpest->value > 0) expect_roller_touches(cam);
  }
}

TEST(CamProfile, TouchesOscillatingRollers) {
  std::mt19937_64 random(2);
  for (const auto side : {cam::ArmSide::trailing, cam::ArmSide::leading}) {
    CamProblem problem = oscillating_roller(40, 80, 60, 9);
    problem.side = side;
    for (int i = 0; i < 3; ++i) {
      problem.motion = random_motion(random, 15 * kDegree);
      expect_roller_touches(cam_of(problem));
    }
  }
}

TEST(CamProfile, TouchesFlatFaces) {
  std::mt19937_64 random(3);
  for (const auto type :
       {cam::FollowerType::translating_flat, cam::FollowerType::oscillating_flat}) {
    const bool swings = is_oscillating(type);
    for (const auto side : {cam::ArmSide::trailing, cam::ArmSide::leading}) {
      CamProblem problem;
      problem.follower = type;
      problem.side = side;
      use(problem, CamDimension::base_radius, 120);
      if (swings) {
        use(problem, CamDimension::centre_distance, 250);
        use(problem, CamDimension::face_offset, 7);
      }
      problem.motion = random_motion(random, swings ? 2 * kDegree : 8);
      const Cam cam = cam_of(problem);
      ASSERT_GT(problems::CamExtremes(cam).convex_radius()->value, 0);
      expect_face_touches(cam);
    }
  }
}

// A roller larger than the pitch curve's radius undercuts, and the profile then crosses itself.
TEST(CamProfile, UndercutCrossesItself) {
  CamProblem problem = translating_roller(30, 0, 5);
  problem.motion = {segment(cam::MotionLaw::harmonic, 60, 20),
                    segment(cam::MotionLaw::harmonic, 60, -20),
                    segment(cam::MotionLaw::dwell, 240)};
  const Cam sound = cam_of(problem);
  const double radius = problems::CamExtremes(sound).convex_radius()->value + 5;
  for (const double share : {0.7, 0.95, 1.05, 1.3}) {
    Cam cam = sound;
    cam.system.follower.dimensions.roller_radius = share * radius;
    EXPECT_EQ(crosses_itself(profile(cam)), share > 1) << share;
  }
}

// Points of the true curve between the polygon's keep within the tolerance, and there are not many
// more than its curvature needs.
TEST(CamProfile, PolygonKeepsItsTolerance) {
  std::mt19937_64 random(5);
  CamProblem problem = translating_roller(50, 8, 6);
  problem.motion = random_motion(random, 20);
  const Cam cam = cam_of(problem);
  const CamCurve curve{cam.system, cam.programme, -6};
  for (const double tolerance : {1e-1, 1e-3, 1e-5}) {
    const auto all = polygon(curve, tolerance);
    double worst = 0, needed = 0;
    const int pieces = int(cam.programme.pieces().size());
    for (int piece = 0; piece < pieces; ++piece) {
      constexpr int kPlaces = 400;
      Vec2d last = curve_point(curve, piece, 0).at;
      for (int i = 1; i < kPlaces; ++i) {
        const auto point = curve_point(curve, piece, double(i) / kPlaces);
        worst = std::max(worst, distance_to_polygon(point.at, all));
        needed += norm(point.at - last) * std::sqrt(std::abs(point.curvature) / (8 * tolerance));
        last = point.at;
      }
    }
    EXPECT_LE(worst, tolerance);
    EXPECT_LE(double(all.size()), 3 * needed + 4 * pieces) << tolerance;
  }
}

// Up and down at constant speed: at 0 the roller sits in a hollow of its own shape, at 180° it goes
// round a corner. The hollow closes the curve, and is an arc about the roller's centre.
TEST(CamProfile, RollerRoundsTheHollowWhereTheTurnBegins) {
  constexpr double kRoller = 6;
  CamProblem problem = translating_roller(50, 0, kRoller);
  problem.motion = {segment(cam::MotionLaw::constant_velocity, 180, 30),
                    segment(cam::MotionLaw::constant_velocity, 180, -30)};
  const Cam cam = cam_of(problem);
  const auto all = profile(cam);
  for (const double tilt : {-0.15, 0.0, 0.15}) {  // flanks lean by atan(30 / π / 50)
    const Vec2d under = Vec2d{0, 50} - kRoller * Vec2d{std::sin(tilt), std::cos(tilt)};
    EXPECT_LE(distance_to_polygon(under, all), kTolerance) << tilt;
  }
  int in_hollow = 0;
  for (const ProfilePoint& point : all) {
    if (std::abs(point.at.x) > 0.15 * kRoller || point.at.y < 0) continue;
    EXPECT_DOUBLE_EQ(point.curvature, -1 / kRoller);
    ++in_hollow;
  }
  EXPECT_GT(in_hollow, 10);
}

}  // namespace
}  // namespace cognate::cam_profile_test
