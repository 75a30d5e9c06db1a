/// Two and three poses.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <random>

#include "analysis/numbers/constants.hpp"
#include "synthesis/exact/motion/guided_mechanism.hpp"
#include "synthesis/exact/motion/three_poses.hpp"
#include "synthesis/exact/motion/two_poses.hpp"

namespace cognate::synthesis::few_poses_test {
namespace {

constexpr double degree = kPi / 180;
using Two = std::array<Pose, 2>;
using Three = std::array<Pose, 3>;

struct Random {
  std::mt19937_64 engine;
  double operator()(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  }
  Vec2d vector(double size) { return {(*this)(-size, size), (*this)(-size, size)}; }
};

Three random_poses(Random& random) {
  Three poses;
  for (Pose& pose : poses) pose = {random.vector(2), random(-3, 3)};
  return poses;
}

Two first_two(const Three& poses) {
  return {poses[0], poses[1]};
}

void expect_at(const Vec2d& found, const Vec2d& expected, double tolerance) {
  EXPECT_NEAR(found.x, expected.x, tolerance);
  EXPECT_NEAR(found.y, expected.y, tolerance);
}

/// The spread of a distance over the poses, by the pivots' places alone.
double spread(const GuidingDyad& dyad, std::span<const Pose> poses) {
  double least = 1e300, greatest = 0;
  for (const Pose& pose : poses) {
    const double length = norm(to_frame(pose, dyad.in_body) - dyad.fixed);
    least = std::min(least, length);
    greatest = std::max(greatest, length);
  }
  return greatest - least;
}

// Li Bincheng, Xu Chao, Mechanism Theory with MATLAB (2011), examples 3-2 to 3-5, recomputed with
// 30 digits.
TEST(TwoPoses, HangTheFurnaceDoor) {
  const std::array<Vec2d, 2> b{{{82, 0}, {0, 60}}}, c{{{32, 0}, {0, 110}}};
  const SegmentPoses door = poses_of_segment(b, c);
  ASSERT_EQ(door.poses.size(), 2U);
  EXPECT_EQ(door.length, 50);
  EXPECT_EQ(door.spread, 0);
  const std::span<const Pose, 2> poses(door.poses);
  const Line line{{-18, 0}, {0, 1}};
  const DyadSolutions first = dyads_with_fixed_pivot_on(poses, {0, 0}, line);
  const DyadSolutions second = dyads_with_fixed_pivot_on(poses, {50, 0}, line);
  ASSERT_EQ(first.count, 1);
  ASSERT_EQ(second.count, 1);
  expect_at(first.storage[0].fixed, {-18, -50.63333333333333}, 1e-13);
  expect_at(second.storage[0].fixed, {-18, 45.10909090909091}, 1e-13);
  const GuidedMechanism guided = guided_mechanism(first.storage[0], second.storage[0], poses);
  const FourBar& linkage = std::get<FourBar>(guided.type);
  EXPECT_NEAR(linkage.crank, 112.08806557544136, 2e-13);
  EXPECT_NEAR(linkage.coupler, 50, 1e-13);
  EXPECT_NEAR(linkage.rocker, 67.34114702501456, 2e-13);
  EXPECT_EQ(guided.stations[0].side, Assembly::open);
  EXPECT_EQ(guided.stations[1].side, Assembly::crossed);
}

TEST(TwoPoses, TellThatADistanceIsNotKept) {
  const std::array<Vec2d, 2> b{{{0, 0}, {1, 0}}}, c{{{3, 0}, {1, 4}}};
  const SegmentPoses poses = poses_of_segment(b, c);
  EXPECT_EQ(poses.spread, 1);
  EXPECT_EQ(poses.length, 3.5);
  EXPECT_TRUE(poses_of_segment(b, std::span(c).first(1)).poses.empty());
  EXPECT_TRUE(poses_of_segment(b, b).poses.empty());
}

// Norton, Design of Machinery, example 5-1: W and U, the driving and the driven link, from the
// moves of the points and the angles that are chosen; recomputed from its dyad equations.
TEST(TwoPoses, GiveNortonsLinkBack) {
  const auto polar = [](double length, double angle) {
    return Vec2d{length * std::cos(angle * degree), length * std::sin(angle * degree)};
  };
  const Two poses{Pose{{0, 0}, 0}, {polar(2.416, 165.2), 43.3 * degree}};
  const Vec2d z = polar(1.298, 26.5), s = polar(1.035, 104.1);
  const Vec2d w = polar(2.46690, 71.571), u = polar(1.48563, 15.416);
  for (const auto& [arm, link] : {std::pair{z, w}, std::pair{s, u}}) {
    const Vec2d moving = -arm, fixed = -arm - link;
    const auto bisector = fixed_pivots_of(poses, moving);
    ASSERT_TRUE(bisector);
    EXPECT_NEAR(cross(bisector->direction, fixed - bisector->point), 0, 2e-5);
    const DyadSolutions found = dyads_of_length(poses, moving, norm(link));
    ASSERT_EQ(found.count, 2);
    EXPECT_LT(std::min(norm(found.storage[0].fixed - fixed), norm(found.storage[1].fixed - fixed)),
              1e-4);
  }
}

TEST(TwoPoses, KeepTheirDistances) {
  Random random{std::mt19937_64(1)};
  for (int trial = 0; trial < 2000; ++trial) {
    const Two poses = first_two(random_poses(random));
    const Vec2d in_body = random.vector(2), fixed = random.vector(2);
    const Line line{random.vector(3), {std::cos(random(0, 6)), std::sin(1.0)}};
    const DyadSolutions a = dyads_with_fixed_pivot_on(poses, in_body, line);
    const DyadSolutions b = dyads_with_moving_pivot_on(poses, fixed, line);
    const DyadSolutions c = dyads_of_length(poses, in_body, 8);
    ASSERT_EQ(a.count + b.count + c.count, 4);
    for (const DyadSolutions* found : {&a, &b, &c}) {
      for (const GuidingDyad& dyad : found->dyads()) {
        EXPECT_LT(spread(dyad, poses), 1e-14 * (10 + dyad.length));
      }
    }
    EXPECT_LT(std::abs(cross(line.direction, a.storage[0].fixed - line.point)), 1e-12);
    expect_at(b.storage[0].fixed, fixed, 1e-15);
    EXPECT_LT(std::abs(cross(line.direction, b.storage[0].in_body - line.point)),
              1e-14 * (10 + squared_norm(b.storage[0].in_body)));
    EXPECT_NEAR(c.storage[0].length, 8, 2e-14);
    EXPECT_EQ(slider_of(poses, in_body).storage[0].kind, DyadKind::pr);
    EXPECT_LT(slider_of(poses, in_body).storage[0].residual, 1e-14);
  }
}

TEST(TwoPoses, NameADegeneracy) {
  const Two turn{Pose{{1, 0}, 0}, {{0, 1}, 90 * degree}};  // about the origin
  const Line line{{5, 5}, {1, 0}};
  ASSERT_TRUE(pole(displacement(turn[0], turn[1])));
  expect_at(*pole(displacement(turn[0], turn[1])), {0, 0}, 1e-15);
  EXPECT_EQ(dyads_with_fixed_pivot_on(turn, {-1, 0}, line).status, GuidanceStatus::pivot_at_rest);
  EXPECT_FALSE(fixed_pivots_of(turn, {-1, 0}));
  EXPECT_EQ(dyads_with_moving_pivot_on(turn, {0, 0}, line).status, GuidanceStatus::pivot_at_rest);
  EXPECT_EQ(dyads_of_length(turn, {0, 0}, 0.5).status, GuidanceStatus::out_of_reach);
  EXPECT_EQ(dyads_of_length(turn, {0, 0}, std::sqrt(0.5)).count, 1);
  EXPECT_EQ(dyads_of_length(turn, {0, 0}, NAN).status, GuidanceStatus::not_finite);
  const Two move{Pose{{0, 0}, 1}, {{2, 0}, 1}};
  EXPECT_FALSE(pole(displacement(move[0], move[1])));
  const DyadSolutions parallel = dyads_with_fixed_pivot_on(move, {0, 0}, {{7, 0}, {0, 1}});
  ASSERT_EQ(parallel.count, 1);
  EXPECT_EQ(parallel.storage[0].kind, DyadKind::pr);
  EXPECT_EQ(dyads_with_fixed_pivot_on(move, {0, 0}, {{1, 9}, {0, 1}}).status,
            GuidanceStatus::same_line);
  EXPECT_EQ(dyads_with_fixed_pivot_on(Two{move[0], move[0]}, {0, 0}, line).status,
            GuidanceStatus::pivot_at_rest);
}

TEST(ThreePoses, GiveTheAntiparallelogram) {
  const std::array<Vec2d, 3> b{{{0, 100}, {100, 200}, {300, 200}}};
  const std::array<Vec2d, 3> c{{{0, 200}, {200, 200}, {300, 100}}};
  const SegmentPoses body = poses_of_segment(b, c);
  EXPECT_EQ(body.spread, 0);
  const std::span<const Pose, 3> poses(body.poses);
  const DyadSolutions first = dyads_with_moving_pivot(poses, {0, 0});
  const DyadSolutions second = dyads_with_moving_pivot(poses, {100, 0});
  expect_at(first.storage[0].fixed, {200, 0}, 1e-12);
  expect_at(second.storage[0].fixed, {100, 0}, 1e-12);
  EXPECT_NEAR(first.storage[0].length, 223.60679774997897, 1e-12);
  EXPECT_NEAR(second.storage[0].length, 223.60679774997897, 1e-12);
}

TEST(ThreePoses, SolveForGivenFixedPivots) {
  const Three poses{Pose{{10, 32}, 52 * degree}, {{36, 39}, 29 * degree}, {{45, 24}, 0}};
  const DyadSolutions first = dyads_with_fixed_pivot(poses, {0, 0});
  const DyadSolutions second = dyads_with_fixed_pivot(poses, {63, 0});
  expect_at(first.storage[0].moving, {-3.0866742487898557, -9.36253499147679}, 2e-13);
  expect_at(second.storage[0].moving, {69.84922920446479, 29.14666394437516}, 2e-13);
  expect_at(first.storage[0].in_body, {-40.65108354483429, -15.15287927906719}, 2e-13);
  EXPECT_NEAR(first.storage[0].length, 9.858225975537877, 2e-13);
  EXPECT_NEAR(second.storage[0].length, 29.940607204624833, 2e-13);
  const GuidedMechanism guided = guided_mechanism(first.storage[0], second.storage[0], poses);
  const std::array angles{-108.24654036669409, 37.77632316229521, 63.822979918472775};
  for (std::size_t j = 0; j < 3; ++j) {
    EXPECT_NEAR(guided.stations[j].drive / degree, angles[j], 1e-12);
    EXPECT_EQ(guided.stations[j].side, j == 2 ? Assembly::crossed : Assembly::open);
  }
}

// Norton, example 5-2: the linear dyad equations W(e^{iβ} − 1) + Z(e^{iα} − 1) = P solved.
TEST(ThreePoses, GiveNortonsLinksBack) {
  const auto polar = [](double length, double angle) {
    return Vec2d{length * std::cos(angle * degree), length * std::sin(angle * degree)};
  };
  const Three poses{
      Pose{{0, 0}, 0}, {polar(2.798, -31.19), -45 * degree}, {polar(3.919, -16.34), 9.27 * degree}};
  const auto check = [&](const Vec2d& arm, const Vec2d& link) {
    const DyadSolutions found = dyads_with_moving_pivot(poses, -arm);
    EXPECT_NEAR(found.storage[0].length, norm(link), 2e-2);  // printed with four figures
    EXPECT_LT(norm(found.storage[0].fixed + arm + link), 2e-2);
  };
  check(polar(1.508, 38.56), polar(6.831, 89.55));
  check(polar(1.491, 94.19), polar(3.199, -145.22));
}

TEST(ThreePoses, KeepTheirDistances) {
  Random random{std::mt19937_64(2)};
  for (int trial = 0; trial < 3000; ++trial) {
    const Three poses = random_poses(random);
    const Vec2d in_body = random.vector(2);
    const DyadSolutions found = dyads_with_moving_pivot(poses, in_body);
    ASSERT_EQ(found.status, GuidanceStatus::found);
    const GuidingDyad& dyad = found.storage[0];
    EXPECT_LT(dyad.residual, 1e-14 * dyad.condition);
    EXPECT_LT(spread(dyad, poses), 1e-14 * dyad.condition * (1 + dyad.length));
    // The same dyad from its other end, where that end is well determined.
    const DyadSolutions back = dyads_with_fixed_pivot(poses, dyad.fixed);
    const double condition = back.storage[0].condition * dyad.condition;
    EXPECT_LT(norm(back.storage[0].in_body - in_body), 1e-14 * condition * condition);
  }
}

TEST(ThreePoses, SlideWherePositionsAreCollinear) {
  Random random{std::mt19937_64(3)};
  for (int trial = 0; trial < 1000; ++trial) {
    const Three poses = random_poses(random);
    const double angle = random(0, 3);
    const Vec2d direction{std::cos(angle), std::sin(angle)};
    const DyadSolutions slider = dyads_with_slide_direction(poses, direction);
    const DyadSolutions block = dyads_with_line_direction(poses, direction);
    ASSERT_EQ(slider.count, 1);
    ASSERT_EQ(block.count, 1);
    EXPECT_EQ(slider.storage[0].kind, DyadKind::pr);
    EXPECT_EQ(block.storage[0].kind, DyadKind::rp);
    for (const DyadSolutions* found : {&slider, &block}) {
      const GuidingDyad& dyad = found->storage[0];
      EXPECT_LT(dyad.residual, 1e-14 * dyad.condition * (1 + norm(dyad.in_body) / extent(poses)));
    }
  }
  // Whole numbers, so that the positions are collinear to the last bit.
  const Three poses{Pose{{0, 0}, 0.3}, {{2, 1}, 1.3}, {{6, 3}, -1}};
  const DyadSolutions found = dyads_with_moving_pivot(poses, {0, 0});
  ASSERT_EQ(found.count, 1);
  EXPECT_EQ(found.storage[0].kind, DyadKind::pr);
  EXPECT_NEAR(cross(found.storage[0].direction, {2, 1}), 0, 1e-15);
  const Vec2d pivot{4, 1};
  Three inverted;
  for (std::size_t j = 0; j < 3; ++j) {
    const Pose& pose = poses[j];
    inverted[j] = {pivot + Vec2d{std::cos(pose.angle), -std::sin(pose.angle)} * -pose.at,
                   -pose.angle};
  }
  const DyadSolutions block = dyads_with_fixed_pivot(inverted, pivot);
  ASSERT_EQ(block.count, 1);
  EXPECT_EQ(block.storage[0].kind, DyadKind::rp);
}

TEST(ThreePoses, NameADegeneracy) {
  Three poses{Pose{{0, 0}, 0}, {{1, 2}, 0.5}, {{-1, 1}, 1.5}};
  const PoleTriangle poles = pole_triangle(poses);
  ASSERT_TRUE(poles.p12 && poles.p23 && poles.p31);
  const DyadSolutions rest = dyads_with_moving_pivot(poses, to_body(poses[0], *poles.p12));
  EXPECT_EQ(rest.status, GuidanceStatus::pivot_at_rest);
  ASSERT_EQ(rest.count, 1);
  EXPECT_LT(rest.storage[0].residual, 1e-15);
  const DyadSolutions pole = dyads_with_fixed_pivot(poses, *poles.p23);
  EXPECT_EQ(pole.status, GuidanceStatus::pivot_at_rest);
  poses[2] = poses[0];
  EXPECT_EQ(dyads_with_moving_pivot(poses, {1, 1}).status, GuidanceStatus::coincident_poses);
  EXPECT_EQ(dyads_with_slide_direction(poses, {1, 1}).status, GuidanceStatus::coincident_poses);
  const Three moves{Pose{{0, 0}, 0.5}, {{1, 0}, 0.5}, {{1, 1}, 0.5}};
  EXPECT_EQ(dyads_with_slide_direction(moves, {1, 1}).status, GuidanceStatus::translation);
  expect_at(dyads_with_moving_pivot(moves, {0, 0}).storage[0].fixed, {0.5, 0.5}, 1e-15);
  EXPECT_FALSE(pole_triangle(moves).p12);
  poses[1].angle = INFINITY;
  EXPECT_EQ(dyads_with_fixed_pivot(poses, {1, 1}).status, GuidanceStatus::not_finite);
}

TEST(FewPoses, DoNotDependOnTheUnit) {
  Random random{std::mt19937_64(5)};
  const Three poses = random_poses(random);
  for (const double scale : {1e-12, 1e12}) {
    Three scaled = poses;
    for (Pose& pose : scaled) pose.at = scale * pose.at;
    const GuidingDyad a = dyads_with_moving_pivot(poses, {1, 2}).storage[0];
    const GuidingDyad b = dyads_with_moving_pivot(scaled, {scale, 2 * scale}).storage[0];
    expect_at((1 / scale) * b.fixed, a.fixed, 1e-13);
    EXPECT_NEAR(b.residual, a.residual, 1e-15);
  }
}

}  // namespace
}  // namespace cognate::synthesis::few_poses_test
