/// Dyads nearest to many poses: planted ones come back, slides are least over all directions, and
/// the links of the McCarthy challenge are those found by two other programs.
#include "synthesis/fit/dyad_fit.hpp"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "analysis/linkage/motion.hpp"
#include "analysis/numbers/constants.hpp"
#include "synthesis/fit/algebraic_dyads.hpp"
#include "synthesis/fit/body_motion.hpp"
#include "synthesis/fit/circle.hpp"
#include "synthesis/optimise/check_derivatives.hpp"

namespace cognate::synthesis::dyad_fit_test {
namespace {

const FourBar linkage{{0.2, -0.3}, {2.1, 0.9}, 0.8, 1.9, 1.6, Assembly::open, Vec2d{1.1, 0.7}};

/// The coupler's poses, its origin at the coupler point.
std::vector<Pose> coupler_poses(int count) {
  std::vector<Pose> poses;
  for (int k = 0; k < count; ++k) {
    const auto at = *Motion(linkage).at(0.3 + 2.5 * k / count);
    const Vec2d along = at.c - at.b;
    poses.push_back({*at.coupler_point, std::atan2(along.y, along.x)});
  }
  return poses;
}

std::vector<Pose> random_poses(std::mt19937_64& random, int count) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<Pose> poses;
  for (int k = 0; k < count; ++k) {
    poses.push_back({{uniform(random), uniform(random)}, 3 * uniform(random)});
  }
  return poses;
}

TEST(RestingPoint, IsThePinOfARotation) {
  const Vec2d pin{3, -2}, in_body{0.5, 4};
  std::vector<Pose> poses;
  for (const double angle : {0.1, 0.5, 1.4, 2.0}) {
    const Vec2d turn{std::cos(angle), std::sin(angle)};
    poses.push_back({pin - turn * in_body, angle});
  }
  const RestingPoint rest = resting_point(poses);
  EXPECT_NEAR(norm(rest.in_body - in_body), 0, 1e-13);
  EXPECT_NEAR(norm(rest.mean - pin), 0, 1e-13);
  EXPECT_NEAR(rest.travel, 0, 1e-13);
}

TEST(RestingPoint, OfATranslationIsTheOrigin) {
  const std::vector<Pose> poses{{{0, 0}, 0.3}, {{2, 0}, 0.3}};
  EXPECT_EQ(resting_point(poses).in_body, (Vec2d{0, 0}));
  EXPECT_NEAR(resting_point(poses).travel, 1, 1e-15);
}

TEST(InverseMotion, TakesTheFrameToTheBody) {
  const auto poses = coupler_poses(5);
  const auto inverse = inverse_motion(poses);
  const Vec2d place{0.7, -1.3};
  for (std::size_t k = 0; k < poses.size(); ++k) {
    EXPECT_NEAR(norm(to_frame(inverse[k], place) - to_body(poses[k], place)), 0, 1e-14);
  }
}

TEST(AlgebraicCircle, IsExactOnACircle) {
  std::vector<Vec2d> points;
  for (const double angle : {0.1, 0.2, 0.7, 0.9}) {
    points.push_back({5 + 2 * std::cos(angle), -3 + 2 * std::sin(angle)});
  }
  const auto circle = algebraic_circle(points);
  ASSERT_TRUE(circle);
  EXPECT_NEAR(norm(circle->centre - Vec2d{5, -3}), 0, 1e-12);
  EXPECT_NEAR(circle->radius, 2, 1e-12);
}

TEST(AlgebraicCircle, IsNoneOnALineAndOfTwoPoints) {
  EXPECT_FALSE(algebraic_circle(std::vector<Vec2d>{{0, 0}, {1, 2}}));
  EXPECT_FALSE(algebraic_circle(std::vector<Vec2d>{{0, 0}, {1, 2}, {2, 4}, {5, 10}}));
}

TEST(LinkModel, HasExactDerivatives) {
  const auto poses = coupler_poses(7);
  const LinkModel model(poses, 1);
  const std::vector<double> x{0.3, -0.4, 1.2, 0.8, 1.1};
  const auto error = check_derivatives(model, x);
  ASSERT_TRUE(error.has_value);
  EXPECT_LT(error.relative, 1e-8) << error.describe(model);
}

TEST(AlgebraicDyads, AreTheLinksOfAPlantedFourBar) {
  for (const int count : {5, 6, 11, 40}) {
    SCOPED_TRACE(count);
    const auto poses = coupler_poses(count);
    int found = 0;
    for (const GuidingDyad& dyad : algebraic_dyads(poses)) {
      const bool crank = norm(dyad.fixed - linkage.pivot_a) < 1e-6;
      const bool rocker = norm(dyad.fixed - linkage.pivot_d) < 1e-6;
      if (!crank && !rocker) continue;
      ++found;
      EXPECT_NEAR(dyad.length, crank ? linkage.crank : linkage.rocker, 1e-6);
      EXPECT_LT(squared_misfit(dyad, poses), 1e-14);
    }
    EXPECT_EQ(found, 2);
  }
}

TEST(AlgebraicDyads, MoveWithTheFrameAndTheBody) {
  int tested = 0;
  const auto poses = coupler_poses(8);
  const Vec2d body_shift{30, -20}, frame_shift{-500, 80};
  const Vec2d turn{std::cos(0.8), std::sin(0.8)};
  std::vector<Pose> moved;
  for (const Pose& pose : poses) {
    moved.push_back({frame_shift + 7.0 * (turn * to_frame(pose, body_shift)), pose.angle + 0.8});
  }
  const auto plain = algebraic_dyads(poses), other = algebraic_dyads(moved);
  ASSERT_EQ(plain.size(), other.size());
  for (const GuidingDyad& dyad : plain) {
    if (squared_misfit(dyad, poses) > 1e-10) continue;
    ++tested;
    const Vec2d fixed = frame_shift + 7.0 * (turn * dyad.fixed);
    const bool is_there = std::ranges::any_of(
        other, [&](const GuidingDyad& o) { return norm(o.fixed - fixed) < 1e-4; });
    EXPECT_TRUE(is_there);
  }
  EXPECT_GE(tested, 2);
}

TEST(NearestLink, ReturnsToThePlantedLink) {
  const auto poses = coupler_poses(12);
  const auto start = rr_dyad(poses, {-1.0, -0.8}, {0.3, -0.2});
  const auto found = nearest_link(start, poses);
  ASSERT_TRUE(found);
  EXPECT_NEAR(norm(found->in_body - Vec2d{-1.1, -0.7}), 0, 1e-9);
  EXPECT_NEAR(norm(found->fixed - linkage.pivot_a), 0, 1e-9);
  EXPECT_NEAR(found->length, linkage.crank, 1e-9);
}

/// The least misfit of a slider in a direction, by dense normal equations in (m, c).
double least_misfit(std::span<const Pose> poses, double direction) {
  const Vec2d n{-std::sin(direction), std::cos(direction)};
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(poses.size()), 3);
  Eigen::VectorXd right(rows.rows());
  for (Eigen::Index j = 0; j < rows.rows(); ++j) {
    const Pose& pose = poses[static_cast<std::size_t>(j)];
    const Vec2d in_body = conj(Vec2d{std::cos(pose.angle), std::sin(pose.angle)}) * n;
    rows.row(j) << in_body.x, in_body.y, -1;
    right[j] = -dot(n, pose.at);
  }
  return (rows * rows.colPivHouseholderQr().solve(right) - right).squaredNorm();
}

TEST(NearestSlider, IsTheLeastOverAllDirections) {
  std::mt19937_64 random(7);
  for (int trial = 0; trial < 20; ++trial) {
    const auto poses = random_poses(random, 9);
    double least = 1e300;
    for (int k = 0; k < 2000; ++k) {
      least = std::min(least, least_misfit(poses, kPi * k / 2000));
    }
    const GuidingDyad slider = nearest_slider(poses);
    EXPECT_LE(squared_misfit(slider, poses), least * (1 + 1e-12));
    EXPECT_GE(squared_misfit(slider, poses), least * (1 - 1e-4));
    const double angle = std::atan2(slider.direction.y, slider.direction.x);
    EXPECT_NEAR(least_misfit(poses, angle), squared_misfit(slider, poses), 1e-12);
    EXPECT_NEAR(squared_misfit(slider_along(poses, {std::cos(0.4), std::sin(0.4)}), poses),
                least_misfit(poses, 0.4), 1e-12);
  }
}

TEST(NearestSlider, AndBlockAreThePlantedOnes) {
  // A body whose point `pin` slides along a line, and whose line `bar` passes through an eye.
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const Vec2d pin{0.4, -1.2}, along{std::cos(0.7), std::sin(0.7)}, through{2, 1};
  std::vector<Pose> sliding, swinging;
  const Vec2d eye{-1, 3}, bar{std::cos(2.0), std::sin(2.0)}, on_bar{0.2, 0.5};
  for (int k = 0; k < 10; ++k) {
    const double angle = 2 * uniform(random);
    const Vec2d turn{std::cos(angle), std::sin(angle)};
    sliding.push_back({through + uniform(random) * along - turn * pin, angle});
    swinging.push_back({eye - turn * (on_bar + uniform(random) * bar), angle});
  }
  const GuidingDyad slider = nearest_slider(sliding);
  EXPECT_NEAR(norm(slider.in_body - pin), 0, 1e-11);
  EXPECT_NEAR(cross(slider.direction, along), 0, 1e-12);
  EXPECT_NEAR(cross(along, slider.fixed - through), 0, 1e-12);
  const GuidingDyad block = nearest_block(swinging);
  EXPECT_EQ(block.kind, DyadKind::rp);
  EXPECT_NEAR(norm(block.fixed - eye), 0, 1e-11);
  EXPECT_NEAR(cross(block.direction, bar), 0, 1e-12);
  EXPECT_NEAR(cross(bar, block.in_body - on_bar), 0, 1e-12);
  EXPECT_NEAR(squared_misfit(block, swinging), 0, 1e-24);
}

}  // namespace
}  // namespace cognate::synthesis::dyad_fit_test
