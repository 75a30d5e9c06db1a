/// Forces, torque, rolling and stress of cams against statics and geometry done another way.
#include <gtest/gtest.h>

#include "analysis/cam/profile.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/cam/extremes.hpp"
#include "problems/cam/quantities.hpp"
#include "tests/support/cam_problems.hpp"

namespace cognate::cam_forces_test {
namespace {

using cam::Cam;
using cam::CamQuantity;
using problems::CamDimension;
using problems::CamProblem;

CamProblem running(CamProblem problem, std::mt19937_64& random) {
  const bool swings = is_oscillating(problem.follower);
  problem.motion = random_motion(random, swings ? 0.12 : 0.012);
  problem.operation = {0.4, 50, 3000, 60, 15, 0.01, 8e-12};
  if (swings) problem.operation = {2e-3, 50, 15, 3, 1, 0.01, 8e-12};
  problem.preload = problem.operation.preload;
  problem.has_operation = problem.has_contact = true;
  return problem;
}

std::vector<CamProblem> every_follower(std::mt19937_64& random) {
  std::vector<CamProblem> all = {translating_roller(0.05, 0.008, 0.006),
                                 oscillating_roller(0.045, 0.09, 0.07, 0.007)};
  all.push_back(all.back());
  all.back().side = cam::ArmSide::leading;
  CamProblem flat;
  flat.follower = cam::FollowerType::translating_flat;
  use(flat, CamDimension::base_radius, 0.06);
  all.push_back(flat);
  flat.follower = cam::FollowerType::oscillating_flat;
  use(flat, CamDimension::centre_distance, 0.12);
  use(flat, CamDimension::face_offset, 0.005);
  all.push_back(flat);
  for (auto& problem : all) problem = running(problem, random);
  return all;
}

/// The contact point and the cam's outward normal, in the frame, with the cam at `angle`.
struct Touch {
  Vec2d at, normal;
};

Touch touch(const Cam& cam, double angle, double distance) {
  const auto& pieces = cam.programme.pieces();
  std::size_t piece = 0;
  while (piece + 1 < pieces.size() && pieces[piece + 1].begin <= angle) ++piece;
  const double t = (angle - pieces[piece].begin) / pieces[piece].span;
  const auto point = cam::curve_point({cam.system, cam.programme, distance}, int(piece), t);
  const Vec2d turn{std::cos(angle), std::sin(angle)};
  return {point.at * turn, point.normal * turn};
}

// Without friction the contact force acts along the common normal: its component along the
// follower's motion (its moment about the pivot) is the demand, and its moment about the cam's
// centre is the torque.
TEST(CamForces, BalanceFollowerAndCam) {
  std::mt19937_64 random(21);
  for (const CamProblem& problem : every_follower(random)) {
    const Cam cam = solve(problem, {.threads = 1}).designs.at(0).cam;
    const auto& d = cam.system.follower.dimensions;
    for (int degree = 3; degree < 360; degree += 11) {
      const double angle = degree * kDegree;
      const auto m = cam.programme.at(angle);
      const Touch contact = touch(cam, angle, -d.roller_radius);
      const double force = value_of(CamQuantity::contact_force, cam.system, m);
      const Vec2d push = force * contact.normal;
      const double demand = value_of(CamQuantity::demand, cam.system, m);
      const double side = sign_of(problem.side);
      const double along = is_oscillating(problem.follower)
                               ? -side * cross(contact.at - Vec2d{0, d.centre_distance}, push)
                               : push.y;
      EXPECT_NEAR(along, demand, 1e-12 * (std::abs(force) + std::abs(demand))) << degree;
      EXPECT_NEAR(cross(contact.at, push), value_of(CamQuantity::torque, cam.system, m),
                  1e-12 * std::abs(force))
          << degree;
    }
  }
}

// The least preload: with it the least contact force is zero, with less it is negative.
TEST(CamForces, LeastPreloadJustKeepsContact) {
  std::mt19937_64 random(22);
  for (CamProblem problem : every_follower(random)) {
    problem.operation.speed = 400;
    problem.operation.preload = 0;
    problem.preload.reset();
    const auto design = solve(problem, {.threads = 1}).designs.at(0);
    ASSERT_GT(design.operation.preload, 0);
    const double greatest = problems::CamExtremes(design.cam).contact_force(false).value;
    EXPECT_NEAR(problems::CamExtremes(design.cam).least_demand().value, 0, 1e-12 * greatest);
  }
}

// A roller that rolls: the way along the profile, by chords, is the way along the roller, by the
// angle that it turns as seen from the line between the two centres.
TEST(CamForces, RollersRollWithoutSliding) {
  int tested = 0;
  std::mt19937_64 random(23);
  for (const CamProblem& problem : every_follower(random)) {
    const Cam cam = solve(problem, {.threads = 1}).designs.at(0).cam;
    const double radius = cam.system.follower.dimensions.roller_radius;
    if (radius == 0) continue;
    ++tested;
    const double side = sign_of(problem.side);
    for (int degree = 5; degree < 355; degree += 23) {
      constexpr double kStep = 1e-5;
      const double angle = degree * kDegree;
      const auto before = touch(cam, angle - kStep, -radius),
                 after = touch(cam, angle + kStep, -radius);
      const auto in_cam = [](const Vec2d& p, double turned) {
        return p * Vec2d{std::cos(turned), -std::sin(turned)};
      };
      const double way = norm(in_cam(after.at, angle + kStep) - in_cam(before.at, angle - kStep));
      // The contact wanders round the roller, as seen from the follower, by the normal's turn.
      double wander =
          std::atan2(cross(before.normal, after.normal), dot(before.normal, after.normal));
      const auto m = cam.programme.at(angle);
      if (is_oscillating(problem.follower)) wander += side * m.velocity * 2 * kStep;
      const double turned = value_of(CamQuantity::roller_speed, cam.system, m) * 2 * kStep;
      EXPECT_NEAR(std::abs(turned - wander) * radius, way, 1e-6 * way) << degree;
    }
  }
  EXPECT_GE(tested, 3);
}

TEST(CamForces, StressIsThatOfHertz) {
  std::mt19937_64 random(24);
  for (const CamProblem& problem : every_follower(random)) {
    const Cam cam = solve(problem, {.threads = 1}).designs.at(0).cam;
    const auto& d = cam.system.follower.dimensions;
    for (int degree = 3; degree < 360; degree += 31) {
      const auto m = cam.programme.at(degree * kDegree);
      const double force = value_of(CamQuantity::contact_force, cam.system, m);
      const double radius =
          is_flat(problem.follower)
              ? value_of(CamQuantity::face_radius, cam.system, m)
              : 1 / (1 / d.roller_radius +
                     1 / (1 / value_of(CamQuantity::pitch_curvature, cam.system, m) -
                          d.roller_radius));
      // p = √(F' E* / (π R)), Johnson, Contact Mechanics, equation 4.45.
      const double pressure = std::sqrt(force / 0.01 / (kPi * radius * 8e-12));
      EXPECT_NEAR(std::sqrt(value_of(CamQuantity::squared_stress, cam.system, m)), pressure,
                  1e-10 * pressure)
          << degree;
    }
  }
}

}  // namespace
}  // namespace cognate::cam_forces_test
