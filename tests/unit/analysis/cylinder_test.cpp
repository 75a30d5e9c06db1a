/// A cylinder as drive: its triangle by the law of cosines in long double, derivatives by
/// differences of that, every body's balance of forces, virtual work, limits of its length.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "analysis/mechanism/assembly_fault.hpp"
#include "analysis/mechanism/assembly_ranges.hpp"
#include "analysis/mechanism/inverse_dynamics.hpp"
#include "analysis/mechanism/joints.hpp"
#include "analysis/mechanism/kinematics.hpp"

namespace cognate::cylinder_test {
namespace {

using Real = long double;

constexpr Vec2d kBase{-2.1, 0.45}, kPivot{-0.45, 0.05}, kEnd{0, 0};
constexpr double kRocker = 0.55, kLink = 0.6, kBucket = 0.42;

/// An excavator's bucket: bodies rod, cylinder, rocker, link, bucket.
Mechanism<double> bucket(Assembly assembly = Assembly::open) {
  Mechanism<double> mechanism;
  mechanism.drive = DrivingRod<double>{};
  mechanism.dyads = {Cylinder<double>{{0, kBase}, {0, kPivot}, kRocker, assembly},
                     Rrr<double>{{3, {kRocker, 0}}, {0, kEnd}, kLink, kBucket, Assembly::open}};
  return mechanism;
}

struct Place {
  Real x = 0, y = 0;
};

/// The meeting of circles about p and q, to the left of the way from p to q where `side` is 1.
Place meet(const Place& p, Real of_p, const Place& q, Real of_q, int side) {
  const Real dx = q.x - p.x, dy = q.y - p.y, d = std::hypot(dx, dy);
  const Real along = (d * d + of_p * of_p - of_q * of_q) / (2 * d);
  const Real across = side * std::sqrt(of_p * of_p - along * along);
  return {p.x + (along * dx - across * dy) / d, p.y + (along * dy + across * dx) / d};
}

/// Angles of cylinder, rocker, link and bucket.
std::array<Real, 4> angles(Real length, int side) {
  const Place base{kBase.x, kBase.y}, pivot{kPivot.x, kPivot.y}, end{kEnd.x, kEnd.y};
  const Place pin = meet(base, length, pivot, kRocker, side);
  const Place top = meet(pin, kLink, end, kBucket, 1);
  const auto angle = [](const Place& from, const Place& to) {
    return std::atan2(to.y - from.y, to.x - from.x);
  };
  return {angle(base, pin), angle(pivot, pin), angle(pin, top), angle(end, top)};
}

/// The derivative of an angle of that order, by central differences of the sixth order and more.
Real derivative(Real length, int side, std::size_t angle, std::size_t order) {
  constexpr Real kStep = 1e-3L;
  const auto at = [&](int k) { return angles(length + k * kStep, side)[angle]; };
  const auto pair = [&](int k, int sign) { return at(k) + sign * at(-k); };
  if (order == 1) {
    return (672 * pair(1, -1) - 168 * pair(2, -1) + 32 * pair(3, -1) - 3 * pair(4, -1)) /
           (840 * kStep);
  }
  if (order == 2) {
    return (8064 * pair(1, 1) - 1008 * pair(2, 1) + 128 * pair(3, 1) - 9 * pair(4, 1) -
            14350 * at(0)) /
           (5040 * kStep * kStep);
  }
  return (-488 * pair(1, -1) + 338 * pair(2, -1) - 72 * pair(3, -1) + 7 * pair(4, -1)) /
         (240 * kStep * kStep * kStep);
}

TEST(Cylinder, MovesAsItsTriangleDoes) {
  for (const Assembly assembly : {Assembly::open, Assembly::crossed}) {
    const int side = assembly == Assembly::open ? 1 : -1;
    Mechanism<double> mechanism = bucket(assembly);
    if (side < 0) mechanism.dyads.pop_back();
    const std::size_t turning = side < 0 ? 2 : 4;
    MechanismMotion<3> motion(mechanism);
    for (double length = 1.3; length < 2.05; length += 0.0625) {
      ASSERT_TRUE(motion.move_to(length));
      const auto bodies = motion.bodies();
      const auto expected = angles(length, side);
      for (std::size_t i = 0; i < turning; ++i) {
        const auto& body = bodies[i + 2];
        EXPECT_NEAR(body.direction.x, static_cast<double>(std::cos(expected[i])), 1e-14);
        EXPECT_NEAR(body.direction.y, static_cast<double>(std::sin(expected[i])), 1e-14);
        for (const std::size_t order : {1UL, 2UL, 3UL}) {
          const auto there = static_cast<double>(derivative(length, side, i, order));
          EXPECT_NEAR(body.turn[order - 1], there,
                      (order < 3 ? 1e-9 : 1e-6) * (1 + std::abs(there)))
              << "length " << length << ", angle " << i << ", order " << order;
        }
      }
      // The rod turns with the cylinder and stands at its end.
      EXPECT_EQ(bodies[1].direction.x, bodies[2].direction.x);
      EXPECT_EQ(bodies[1].turn, bodies[2].turn);
      const Vec2d pin = kBase + length * bodies[2].direction;
      EXPECT_LT(norm(bodies[1].origin[0] - pin), 1e-14);
      const auto carried = motion.point({3, {kRocker, 0}});
      for (const std::size_t order : {1UL, 2UL, 3UL}) {
        const double size = 1 + norm(carried[order]);
        EXPECT_LT(norm(bodies[1].origin[order] - carried[order]), 1e-10 * size);
      }
    }
  }
}

TEST(Cylinder, EndsWhereItsTriangleIsFlat) {
  const double frame = norm(kPivot - kBase);
  Mechanism<double> mechanism = bucket();
  mechanism.dyads.pop_back();
  const AssemblyRanges ranges = follow(mechanism, 0.5, 3);
  ASSERT_EQ(ranges.runs.size(), 1U);
  EXPECT_NEAR(ranges.runs[0].from, frame - kRocker, 1e-14);
  EXPECT_NEAR(ranges.runs[0].to, frame + kRocker, 1e-14);
  ASSERT_EQ(ranges.points.size(), 2U);
  EXPECT_EQ(ranges.points[0].kind, SpecialPositionKind::dead_point);
  const auto beyond = assembly_fault(mechanism, frame + kRocker + 0.01);
  ASSERT_TRUE(beyond);
  EXPECT_EQ(beyond->dyad, 0);
  EXPECT_EQ(beyond->kind, AssemblyFaultKind::too_near);
  EXPECT_NEAR(beyond->first, frame + kRocker + 0.01, 1e-12);
  const auto within = assembly_fault(mechanism, frame - kRocker - 0.01);
  ASSERT_TRUE(within);
  EXPECT_EQ(within->kind, AssemblyFaultKind::too_far_apart);
  EXPECT_NEAR(within->distance, frame, 1e-12);
}

struct Loaded {
  std::vector<Inertia> inertias{{},
                                {.mass = 25, .centre = {-0.4, 0.02}, .moment = 2},
                                {.mass = 55, .centre = {0.5, -0.03}, .moment = 6},
                                {.mass = 40, .centre = {0.2, 0.1}, .moment = 1},
                                {.mass = 30, .centre = {0.3, 0.05}, .moment = 1.5},
                                {.mass = 420, .centre = {-0.35, -0.25}, .moment = 60}};
  Vec2d gravity{0.3, -9.81};
  std::vector<Load> loads{{.at = {5, {-0.75, -0.65}}, .force = {9000, 6000}, .torque = 70},
                          {.at = {1, {-0.1, 0}}, .force = {-200, 50}, .torque = -3}};
};

TEST(Cylinder, BalancesEveryBodyAndTheWorkOfItsForce) {
  const Mechanism<double> mechanism = bucket();
  const Loaded given;
  const JointList list = joints(mechanism);
  ASSERT_EQ(list.joints.size(), 7U);
  InverseDynamics dynamics(mechanism, given.inertias, given.gravity);
  MechanismMotion<2> motion(mechanism);
  Forces forces = dynamics.forces();
  const DriveRate rate{0.25, -0.4};
  for (double length = 1.3; length < 2.05; length += 0.0625) {
    ASSERT_TRUE(motion.move_to(length));
    const auto bodies = motion.bodies();
    ASSERT_TRUE(dynamics.solve<2>(bodies, rate, given.loads, forces));
    EXPECT_NEAR(forces.drive, dynamics.drive<2>(bodies, rate, given.loads),
                1e-10 * std::abs(forces.drive));
    for (int body = 1; body < 6; ++body) {
      Vec2d force{};
      double moment = 0;  // about the origin of the frame
      const auto add = [&](const Vec2d& at, const Vec2d& f, double couple) {
        force = force + f;
        moment += cross(at, f) + couple;
      };
      for (std::size_t i = 0; i < list.joints.size(); ++i) {
        const Joint& joint = list.joints[i];
        const double sign = joint.second == body ? 1 : joint.first == body ? -1 : 0;
        const Reaction& reaction = forces.reactions[i];
        add(motion.point(joint.at)[0], sign * reaction.force, sign * reaction.moment);
      }
      // The oil pushes rod and cylinder apart.
      const Vec2d push = forces.drive * bodies[2].direction;
      if (body == 1) add(bodies[1].origin[0], push, 0);
      if (body == 2) add(bodies[1].origin[0], -push, 0);
      for (const Load& load : given.loads) {
        if (load.at.body == body) add(motion.point(load.at)[0], load.force, load.torque);
      }
      const Inertia& inertia = given.inertias[static_cast<std::size_t>(body)];
      const auto centre = motion.point({body, inertia.centre});
      const auto& turn = bodies[static_cast<std::size_t>(body)].turn;
      const Vec2d inertial = inertia.mass * (rate.speed * rate.speed * centre[2] +
                                             rate.acceleration * centre[1] - given.gravity);
      add(centre[0], -inertial,
          -inertia.moment * (rate.speed * rate.speed * turn[1] + rate.acceleration * turn[0]));
      EXPECT_LT(norm(force), 1e-8) << "body " << body << " at " << length;
      EXPECT_NEAR(moment, 0, 1e-8) << "body " << body << " at " << length;
    }
  }
}

}  // namespace
}  // namespace cognate::cylinder_test
