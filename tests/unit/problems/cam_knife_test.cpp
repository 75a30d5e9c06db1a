/// Knife edges on an arm against distances, differences, statics and grids that know nothing of a
/// pitch curve's derivatives.
#include <gtest/gtest.h>

#include "analysis/cam/profile.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/cam/extremes.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/read.hpp"
#include "tests/support/cam_problems.hpp"

namespace cognate::cam_knife_test {
namespace {

using cam::ArmSide;
using cam::Cam;
using cam::CamQuantity;
using problems::CamDimension;
using problems::CamProblem;

CamProblem oscillating_knife(std::optional<double> base, std::optional<double> centre_distance,
                             std::optional<double> arm) {
  CamProblem problem = oscillating_roller(base, centre_distance, arm, 0);
  problem.follower = cam::FollowerType::oscillating_knife;
  return problem;
}

/// What the tests compute the edge by.
struct Arm {
  double base, centre_distance, arm, side;

  double start() const {
    return std::acos((centre_distance * centre_distance + arm * arm - base * base) /
                     (2 * centre_distance * arm));
  }
  /// The edge in the frame.
  Vec2d edge(double displacement) const {
    const double angle = start() + displacement;
    return {-side * arm * std::sin(angle), centre_distance - arm * std::cos(angle)};
  }
  /// The same in the cam, which has turned by `angle`.
  Vec2d in_cam(double displacement, double angle) const {
    return edge(displacement) * Vec2d{std::cos(angle), -std::sin(angle)};
  }
};

Arm arm_of(const Cam& cam) {
  const auto& d = cam.system.follower.dimensions;
  return {d.base_radius, d.centre_distance, d.arm,
          static_cast<double>(sign_of(cam.system.follower.side))};
}

/// The angle between the profile's normal, by a difference of the edge's places in the cam, and the
/// way that the arm gives way; positive where the cam pushes along with its surface.
double pressure_by_difference(const Arm& arm, const cam::MotionProgramme& programme, double angle) {
  constexpr double kStep = 1e-5;
  const auto place = [&](double at) { return arm.in_cam(programme.at(at).displacement, at); };
  const Vec2d turn{std::cos(angle), std::sin(angle)};
  const Vec2d tangent = (place(angle + kStep) - place(angle - kStep)) * turn;
  Vec2d normal = perp(tangent);
  const Vec2d at = arm.edge(programme.at(angle).displacement);
  if (dot(normal, at) < 0) normal = -1.0 * normal;
  const Vec2d reach = at - Vec2d{0, arm.centre_distance};
  const Vec2d way = arm.side * Vec2d{reach.y, -reach.x};
  return std::atan2(cross(way, normal), dot(way, normal));
}

TEST(CamKnife, TheProfileIsThePathOfTheEdge) {
  int tested = 0;
  std::mt19937_64 random(31);
  for (const auto side : {ArmSide::trailing, ArmSide::leading}) {
    for (int i = 0; i < 3; ++i) {
      CamProblem problem = oscillating_knife(30, 80, 65);
      problem.side = side;
      problem.motion = random_motion(random, 28 * kDegree);
      const auto result = solve(problem, {.threads = 1});
      ASSERT_EQ(result.designs.size(), 1U);
      const Cam& cam = result.designs[0].cam;
      const auto& pieces = cam.programme.pieces();
      for (std::size_t piece = 0; piece < pieces.size(); ++piece) {
        for (const double t : {0.0, 0.21, 0.5, 0.83, 1.0}) {
          const auto point = cam::curve_point({cam.system, cam.programme, 0}, int(piece), t);
          const double angle = pieces[piece].begin + t * pieces[piece].span;
          const Vec2d wanted = arm_of(cam).in_cam(motion_at(pieces[piece], t).displacement, angle);
          EXPECT_NEAR(norm(point.at - wanted), 0, 1e-12 * 80) << piece << ' ' << t;
          ++tested;
        }
      }
    }
  }
  EXPECT_GE(tested, 6 * 3 * 5);
}

TEST(CamKnife, PressureAngleIsThatOfThePathsNormal) {
  int tested = 0;
  std::mt19937_64 random(32);
  for (const auto side : {ArmSide::trailing, ArmSide::leading}) {
    CamProblem problem = oscillating_knife(30, 80, 65);
    problem.side = side;
    problem.motion = random_motion(random, 20 * kDegree);
    const Cam cam = solve(problem, {.threads = 1}).designs.at(0).cam;
    for (int degree = 1; degree < 360; degree += 7) {
      const double angle = degree * kDegree;
      const double found =
          value_of(CamQuantity::pressure_angle, cam.system, cam.programme.at(angle));
      const double wanted = pressure_by_difference(arm_of(cam), cam.programme, angle);
      EXPECT_NEAR(found, wanted, 1e-7) << degree;
      ++tested;
    }
  }
  EXPECT_EQ(tested, 104);
}

// The contact force has the demanded moment about the pivot, and the torque about the cam's centre.
TEST(CamKnife, ForcesBalance) {
  int tested = 0;
  std::mt19937_64 random(33);
  for (const auto side : {ArmSide::trailing, ArmSide::leading}) {
    CamProblem problem = oscillating_knife(0.04, 0.09, 0.07);
    problem.side = side;
    problem.motion = random_motion(random, 0.15);
    problem.operation = {2e-3, 50, 15, 3, 1};
    problem.preload = problem.operation.preload;
    problem.has_operation = true;
    const auto result = solve(problem, {.threads = 1});
    ASSERT_EQ(result.designs.size(), 1U);
    const Cam& cam = result.designs[0].cam;
    const Arm arm = arm_of(cam);
    for (int degree = 3; degree < 360; degree += 11) {
      const double angle = degree * kDegree;
      const auto m = cam.programme.at(angle);
      const Vec2d at = arm.edge(m.displacement);
      const double pressure = pressure_by_difference(arm, cam.programme, angle);
      const double force = value_of(CamQuantity::contact_force, cam.system, m);
      const double demand = value_of(CamQuantity::demand, cam.system, m);
      EXPECT_NEAR(force * arm.arm * std::cos(pressure), demand, 1e-6 * std::abs(force)) << degree;
      const Vec2d reach = at - Vec2d{0, arm.centre_distance};
      const Vec2d way = (arm.side / norm(reach)) * Vec2d{reach.y, -reach.x};
      const Vec2d push = force * (way * Vec2d{std::cos(pressure), std::sin(pressure)});
      EXPECT_NEAR(cross(at, push), value_of(CamQuantity::torque, cam.system, m),
                  1e-6 * std::abs(force) * arm.base)
          << degree;
      ++tested;
    }
  }
  EXPECT_EQ(tested, 66);
}

/// The least base radius for a centre distance at which the pressure angle keeps a limit at the
/// positions of a fine grid, in steps of a thousandth of `expected`.
double least_base(const cam::MotionProgramme& programme, const Arm& like, double limit,
                  double expected) {
  const auto kept = [&](double base) {
    const Arm made{base, like.centre_distance, like.arm, like.side};
    for (int i = 0; i < 720; ++i) {
      const double pressure = pressure_by_difference(made, programme, i * kTurn / 720);
      if (!(std::abs(pressure) <= limit)) return false;
    }
    return true;
  };
  for (int i = 1; i < 1300; ++i) {
    const double base = i * 1e-3 * expected;
    if (base > std::abs(like.centre_distance - like.arm) && kept(base)) return base;
  }
  return HUGE_VAL;
}

// No centre distance of a grid has a smaller cam within the limit, and the nearest one has nearly
// the same.
TEST(CamKnife, SmallestCamIsThatOfAGrid) {
  std::mt19937_64 random(34);
  int tested = 0;
  for (const auto side : {ArmSide::trailing, ArmSide::leading}) {
    CamProblem problem = oscillating_knife({}, {}, 50);
    problem.side = side;
    problem.motion = random_motion(random, 15 * kDegree);
    problem.constraints.pressure_angle_max = 40 * kDegree;
    const auto result = solve(problem, {.threads = 1});
    ASSERT_EQ(result.designs.size(), 1U);
    const auto& design = result.designs[0];
    EXPECT_EQ(design.origin, "exact:half-planes");
    EXPECT_TRUE(design.proof);
    EXPECT_TRUE(problems::all_satisfied(design.constraints));
    const Arm found = arm_of(design.cam);
    double best = HUGE_VAL;
    for (int i = -6; i <= 6; ++i) {
      Arm other = found;
      other.centre_distance *= 1 + 0.005 * i;
      best = std::min(best, least_base(design.cam.programme, other, 40 * kDegree, found.base));
      ++tested;
    }
    EXPECT_GT(best, found.base * (1 - 1e-3));
    EXPECT_LT(best, found.base * (1 + 1e-2));
  }
  EXPECT_EQ(tested, 26);
}

// A hollow profile guides an edge: nothing of it is undercut, and the least concave radius is that
// of the path.
TEST(CamKnife, HollowsAreNoUndercut) {
  CamProblem problem = oscillating_knife(30, 80, 65);
  problem.motion = {segment(cam::MotionLaw::cycloidal, 50, 25 * kDegree),
                    segment(cam::MotionLaw::cycloidal, 50, -25 * kDegree),
                    segment(cam::MotionLaw::dwell, 260)};
  const auto result = solve(problem, {.threads = 1});
  ASSERT_EQ(result.designs.size(), 1U);
  EXPECT_EQ(result.status, problems::Status::solved);
  const problems::CamExtremes extremes(result.designs[0].cam);
  const auto hollow = extremes.concave_radius();
  ASSERT_TRUE(hollow);
  EXPECT_GT(hollow->value, 0);
  // The circle through three places of the edge near there.
  constexpr double kStep = 1e-3;
  const auto& programme = result.designs[0].cam.programme;
  const Arm arm = arm_of(result.designs[0].cam);
  const auto place = [&](double angle) {
    return arm.in_cam(programme.at(angle).displacement, angle);
  };
  const Vec2d a = place(hollow->angle - kStep), b = place(hollow->angle),
              c = place(hollow->angle + kStep);
  const double twice_area = std::abs(cross(b - a, c - a));
  const double radius = norm(b - a) * norm(c - b) * norm(c - a) / (2 * twice_area);
  EXPECT_NEAR(hollow->value, radius, 1e-3 * radius);
}

// What a file says is what the problem holds: no radius, no prime circle beside the base circle.
TEST(CamKnife, ResultsHaveTheBaseCircleAlone) {
  CamProblem problem = oscillating_knife(30, 80, 65);
  problem.motion = {segment(cam::MotionLaw::harmonic, 180, 20 * kDegree),
                    segment(cam::MotionLaw::harmonic, 180, -20 * kDegree)};
  const auto result = solve(problem, {.threads = 1});
  ASSERT_EQ(result.designs.size(), 1U);
  int base = 0, prime = 0, undercut = 0;
  for (const auto& quantity : result.designs[0].metrics) {
    base += quantity.name == "base_radius" ? 1 : 0;
    prime += quantity.name == "prime_radius" || quantity.name.starts_with("roller_speed") ? 1 : 0;
    if (quantity.name == "undercut") undercut = std::get<bool>(quantity.value) ? 1 : 0;
  }
  EXPECT_EQ(base, 1);
  EXPECT_EQ(prime, 0);
  EXPECT_EQ(undercut, 0);
  problem.length(CamDimension::roller_radius).given = 1;
  EXPECT_EQ(solve(problem, {.threads = 1}).status, problems::Status::invalid);
}

}  // namespace
}  // namespace cognate::cam_knife_test
