/// Four-bars followed through their change points, against geometry that needs no closure.
#include "analysis/linkage/change_point.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "analysis/linkage/mobility.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::change_point_test {
namespace {

constexpr double pi = kPi;

/// A linkage of these lengths with its frame at an angle of 0.4 from the x axis.
constexpr double frame_at = 0.4;
FourBar linkage_of(const Lengths<double>& l, Assembly assembly = Assembly::open) {
  const Vec2d a{0.3, -1.2};
  return {a,
          a + l.frame * Vec2d{std::cos(frame_at), std::sin(frame_at)},
          l.crank,
          l.coupler,
          l.rocker,
          assembly,
          Vec2d{0.2, 0.5}};
}

/// The turn from one angle to another, in (−π, π].
double turn(double from, double to) {
  return std::remainder(to - from, 2 * pi);
}

double coupler_angle(const Pose& pose) {
  return std::atan2(pose.c.y - pose.b.y, pose.c.x - pose.b.x);
}

struct Followed {
  ChangePointMotion motion;
  double start;
};

Followed follow(const Lengths<double>& links, Assembly assembly, double from_frame = 0.5) {
  const auto motion =
      ChangePointMotion::through(linkage_of(links, assembly), frame_at + from_frame);
  EXPECT_TRUE(motion);
  return {*motion, frame_at + from_frame};
}

/// Angles and rates go on without a step over `turns` turns, and the rates are those of the angles
/// (by the trapezium rule).
void expect_smooth(const Followed& followed, double turns) {
  constexpr double kStep = 1e-3;
  const auto& [motion, start] = followed;
  std::optional<ChangePointPose> before = motion.at(start);
  for (double angle = start + kStep; angle < start + turns * 2 * pi; angle += kStep) {
    const auto now = motion.at(angle);
    ASSERT_TRUE(before && now) << angle;
    const double rocker = 0.5 * kStep * (before->rocker_rate + now->rocker_rate);
    const double coupler = 0.5 * kStep * (before->coupler_rate + now->coupler_rate);
    ASSERT_NEAR(turn(before->pose.rocker_angle, now->pose.rocker_angle), rocker, 1e-7) << angle;
    ASSERT_NEAR(turn(coupler_angle(before->pose), coupler_angle(now->pose)), coupler, 1e-7)
        << angle;
    ASSERT_NEAR(before->rocker_rate, now->rocker_rate, 0.05) << angle;
    before = now;
  }
}

TEST(ChangePoint, ClassesAreNamedFromTheLengths) {
  using enum ChangePointClass;
  const struct {
    Lengths<double> links;
    ChangePointClass expected;
  } cases[] = {{{0.1, 0.3, 0.5, 0.7}, single},      {{0.7, 0.5, 0.3, 0.1}, single},
               {{0.1, 0.7, 0.3, 0.5}, single},      {{0.3, 0.7, 0.3, 0.7}, parallelogram},
               {{0.3, 0.7, 0.7, 0.3}, kite_b_on_d}, {{0.3, 0.3, 0.7, 0.7}, kite_c_on_a},
               {{0.7, 0.7, 0.7, 0.7}, rhombus},     {{0.1, 0.3, 0.5, 0.7 + 1e-13}, none},
               {{0.3, 0.7, 0.3, 0.7 + 1e-13}, none}};
  for (const auto& [links, expected] : cases) {
    for (const double k : {1e-100, 1.0, 3.0, 1e100}) {
      const Lengths<double> scaled{k * links.crank, k * links.coupler, k * links.rocker,
                                   k * links.frame};
      EXPECT_EQ(change_point_class(scaled), expected) << k << " " << int(expected);
      EXPECT_EQ(is_change_point(scaled), expected != none);
    }
  }
  EXPECT_FALSE(ChangePointMotion::through(linkage_of({1, 2, 3, 3.5}), 0.3));
}

TEST(ChangePoint, AParallelogramStaysOne) {
  const Followed followed = follow({0.3, 0.7, 0.3, 0.7}, Assembly::open);
  EXPECT_EQ(followed.motion.path(), ChangePointPath::parallelogram);
  EXPECT_DOUBLE_EQ(followed.motion.period(), 2 * pi);
  for (int i = -200; i <= 600; ++i) {  // through the change points themselves, four turns on
    const double angle = frame_at + i * pi / 90;
    const auto at = followed.motion.at(angle);
    ASSERT_TRUE(at && at->determined);
    EXPECT_NEAR(turn(angle, at->pose.rocker_angle), 0, 4e-15);
    EXPECT_NEAR(turn(frame_at, coupler_angle(at->pose)), 0, 4e-15);
    EXPECT_NEAR(at->rocker_rate, 1, 1e-14);
    EXPECT_NEAR(at->coupler_rate, 0, 1e-14);
  }
}

TEST(ChangePoint, AnAntiparallelogramRollsAsEllipses) {
  // Ellipses with the short links as foci roll on each other: tan(ψ/2) = −(b + a)/(b − a)·tan(θ/2).
  const double a = 0.3, b = 0.7;
  const Followed followed = follow({a, b, a, b}, Assembly::crossed);
  EXPECT_EQ(followed.motion.path(), ChangePointPath::antiparallelogram);
  for (int i = -200; i <= 600; ++i) {
    const double theta = i * pi / 90;
    const auto at = followed.motion.at(frame_at + theta);
    ASSERT_TRUE(at && at->determined);
    const double psi =
        2 * std::atan2(-(b + a) * std::sin(theta / 2), (b - a) * std::cos(theta / 2));
    EXPECT_NEAR(turn(frame_at + psi, at->pose.rocker_angle), 0, 1e-14) << i;
  }
  const auto towards = followed.motion.at(frame_at), away = followed.motion.at(frame_at + pi);
  EXPECT_NEAR(towards->rocker_rate, -(b + a) / (b - a), 1e-14);
  EXPECT_NEAR(away->rocker_rate, -(b - a) / (b + a), 1e-14);
  expect_smooth(followed, 2);
  const auto angles = followed.motion.change_angles();
  ASSERT_EQ(angles.size(), 2u);
  EXPECT_NEAR(angles[0].crank_angle, frame_at, 1e-15);
  EXPECT_NEAR(angles[1].crank_angle, frame_at + pi, 1e-15);
  EXPECT_TRUE(angles[0].determined && angles[1].determined);
}

TEST(ChangePoint, AParallelogramWithALongCrankStaysOneToo) {
  for (const Assembly assembly : {Assembly::open, Assembly::crossed}) {
    expect_smooth(follow({0.7, 0.3, 0.7, 0.3}, assembly, 4.0), 2);
  }
}

TEST(ChangePoint, ADeltoidTurnsTwiceForOneTurnOfItsRocker) {
  // C is on the bisector of the crank angle: AC = a cos(θ/2) ± √(b² − a² sin²(θ/2)).
  const double a = 0.3, b = 0.7;
  for (const Assembly assembly : {Assembly::open, Assembly::crossed}) {
    const Followed followed = follow({a, b, b, a}, assembly);
    EXPECT_EQ(followed.motion.path(), ChangePointPath::deltoid);
    EXPECT_DOUBLE_EQ(followed.motion.period(), 4 * pi);
    // To the left of B→D, at a start between 0 and π, is away from A.
    const double side = sign(assembly);
    const Vec2d pivot = linkage_of({a, b, b, a}).pivot_a;
    for (int i = -200; i <= 600; ++i) {
      const double half = i * pi / 180;
      const auto at = followed.motion.at(frame_at + 2 * half);
      ASSERT_TRUE(at);
      const double reach =
          a * std::cos(half) + side * std::sqrt(b * b - std::pow(a * std::sin(half), 2));
      const Vec2d c = pivot + reach * Vec2d{std::cos(frame_at + half), std::sin(frame_at + half)};
      EXPECT_NEAR(at->pose.c.x, c.x, 2e-15) << i;
      EXPECT_NEAR(at->pose.c.y, c.y, 2e-15) << i;
      EXPECT_EQ(at->determined, i % 180 != 0) << i;  // B on D
    }
    expect_smooth(followed, 2);
    const auto angles = followed.motion.change_angles();
    ASSERT_EQ(angles.size(), 1u);
    EXPECT_FALSE(angles[0].determined);
  }
}

TEST(ChangePoint, ADeltoidWithALongCrankEndsAtItsDeadPoints) {
  const Followed followed = follow({0.7, 0.3, 0.3, 0.7}, Assembly::open);
  const double limit = 2 * std::asin(0.3 / 0.7);
  EXPECT_TRUE(followed.motion.at(frame_at + limit - 1e-6));
  EXPECT_TRUE(followed.motion.at(frame_at - limit + 1e-6));
  EXPECT_FALSE(followed.motion.at(frame_at + limit + 1e-6));
}

TEST(ChangePoint, AKiteOnACarriesCOrLeavesItThere) {
  const double a = 0.3, b = 0.7;
  const FourBar linkage = linkage_of({a, a, b, b});
  const Followed deltoid = follow({a, a, b, b}, Assembly::open);
  const Followed folded = follow({a, a, b, b}, Assembly::crossed);
  EXPECT_EQ(deltoid.motion.path(), ChangePointPath::deltoid);
  EXPECT_EQ(folded.motion.path(), ChangePointPath::folded);
  for (int i = -200; i <= 600; ++i) {
    const double angle = frame_at + i * pi / 90;
    const auto rests = folded.motion.at(angle), moves = deltoid.motion.at(angle);
    ASSERT_TRUE(rests && moves);
    EXPECT_NEAR(rests->pose.c.x, linkage.pivot_a.x, 2e-15);
    EXPECT_NEAR(rests->pose.c.y, linkage.pivot_a.y, 2e-15);
    EXPECT_NEAR(rests->coupler_rate, 1, 4e-15);
    EXPECT_NEAR(rests->rocker_rate, 0, 4e-15);
    // The mirror image of A in the line B–D.
    const Vec2d bd = linkage.pivot_d - moves->pose.b;
    const Vec2d ba = linkage.pivot_a - moves->pose.b;
    const Vec2d mirror = moves->pose.b + (1 / squared_norm(bd)) * (bd * bd) * conj(ba);
    EXPECT_NEAR(moves->pose.c.x, mirror.x, 3e-15);
    EXPECT_NEAR(moves->pose.c.y, mirror.y, 3e-15);
  }
  expect_smooth(deltoid, 2);
}

TEST(ChangePoint, ARhombusIsAParallelogramOrFolds) {
  const Followed parallel = follow({0.5, 0.5, 0.5, 0.5}, Assembly::open);
  const Followed folded = follow({0.5, 0.5, 0.5, 0.5}, Assembly::crossed);
  EXPECT_EQ(parallel.motion.path(), ChangePointPath::parallelogram);
  EXPECT_EQ(folded.motion.path(), ChangePointPath::folded);
  for (int i = -200; i <= 600; ++i) {
    const double angle = frame_at + i * pi / 90;
    const auto moves = parallel.motion.at(angle), rests = folded.motion.at(angle);
    ASSERT_TRUE(moves && rests);
    EXPECT_NEAR(turn(angle, moves->pose.rocker_angle), 0, 4e-15);
    EXPECT_EQ(moves->rocker_rate, 1);
    EXPECT_NEAR(turn(frame_at + pi, rests->pose.rocker_angle), 0, 4e-15);
    EXPECT_EQ(rests->rocker_rate, 0);
    EXPECT_EQ(moves->determined, i % 180 != 0);
  }
}

TEST(ChangePoint, ASingleOneJoinsBothAssembliesInTwoTurns) {
  // Sums that are equal on paper and not in binary, towards D and away from it.
  const Lengths<double> all[] = {{0.1, 0.7, 0.3, 0.5}, {0.1, 0.3, 0.7, 0.5}, {0.1, 0.3, 0.5, 0.7}};
  for (const Lengths<double>& links : all) {
    ASSERT_EQ(change_point_class(links), ChangePointClass::single);
    const Followed followed = follow(links, Assembly::open);
    EXPECT_EQ(followed.motion.path(), ChangePointPath::single);
    EXPECT_DOUBLE_EQ(followed.motion.period(), 4 * pi);
    expect_smooth(followed, 2);
    const auto first = followed.motion.at(followed.start);
    const auto second = followed.motion.at(followed.start + 2 * pi);
    const auto third = followed.motion.at(followed.start + 4 * pi);
    EXPECT_NEAR(first->pose.transmission_angle,
                Motion(linkage_of(links)).at(followed.start)->transmission_angle, 1e-14);
    EXPECT_GT(std::abs(turn(first->pose.rocker_angle, second->pose.rocker_angle)), 0.1);
    EXPECT_NEAR(turn(first->pose.rocker_angle, third->pose.rocker_angle), 0, 1e-14);
    const auto crossed = Motion(linkage_of(links, Assembly::crossed)).at(followed.start);
    EXPECT_NEAR(turn(second->pose.rocker_angle, crossed->rocker_angle), 0, 1e-14);
    // Within a billionth of the change point too.
    const ChangeAngle change = followed.motion.change_angles().at(0);
    for (const double off : {-1e-9, -1e-15, 0.0, 1e-15, 1e-9}) {
      const auto at = followed.motion.at(change.crank_angle + off);
      ASSERT_TRUE(at) << off;
      EXPECT_NEAR(at->rocker_rate, followed.motion.at(change.crank_angle)->rocker_rate, 1e-7);
    }
  }
}

TEST(ChangePoint, TheStartDecidesTheAssembly) {
  std::mt19937_64 random(21);
  std::uniform_real_distribution<double> angle(-20, 20);
  for (int i = 0; i < 300; ++i) {
    const double start = angle(random);
    for (const Lengths<double> links : {Lengths<double>{0.3, 0.7, 0.3, 0.7},
                                        {0.1, 0.3, 0.5, 0.7},
                                        {0.3, 0.7, 0.7, 0.3},
                                        {0.3, 0.3, 0.7, 0.7}}) {
      for (const Assembly assembly : {Assembly::open, Assembly::crossed}) {
        const FourBar linkage = linkage_of(links, assembly);
        const auto at = ChangePointMotion::through(linkage, start)->at(start);
        const auto expected = Motion(linkage).at(start);
        ASSERT_TRUE(at && expected);
        EXPECT_NEAR(at->pose.c.x, expected->c.x, 1e-12);
        EXPECT_NEAR(at->pose.coupler_point->y, expected->coupler_point->y, 1e-12);
      }
    }
  }
}

}  // namespace
}  // namespace cognate::change_point_test
