#include "synthesis/exact/motion/burmester_curves.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <random>
#include <vector>

#include "analysis/linkage/double_slider.hpp"
#include "analysis/linkage/four_bar.hpp"
#include "analysis/mechanism/kinematics.hpp"
#include "analysis/numbers/constants.hpp"
#include "synthesis/exact/motion/five_poses.hpp"

namespace cognate::synthesis::burmester_curves_test {
namespace {

using Poses = std::array<Pose, 4>;

struct Random {
  std::mt19937_64 engine;
  double operator()(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine);
  }
  Vec2d vector(double size) { return {(*this)(-size, size), (*this)(-size, size)}; }
};

template <std::size_t Count>
std::array<Pose, Count> random_poses(Random& random) {
  std::array<Pose, Count> poses;
  for (Pose& pose : poses) pose = {random.vector(2), random(-3, 3)};
  return poses;
}

Poses without(const std::array<Pose, 5>& poses, std::size_t omitted) {
  Poses four;
  for (std::size_t j = 0, k = 0; j < 5; ++j) {
    if (j != omitted) four[k++] = poses[j];
  }
  return four;
}

Vec2d pole_of(const Poses& poses, std::size_t i, std::size_t j) {
  return *pole(displacement(poses[i], poses[j]));
}

/// Burmester's theorem: from a centre point opposite sides of the opposite-pole quadrilateral P12
/// P23 P34 P14 subtend equal angles, or angles that differ by π: the sine of their difference.
double angle_error(const Poses& poses, const Vec2d& centre) {
  const Vec2d a = pole_of(poses, 0, 1) - centre, b = pole_of(poses, 1, 2) - centre;
  const Vec2d c = pole_of(poses, 2, 3) - centre, d = pole_of(poses, 0, 3) - centre;
  const Vec2d first = conj(a) * b, second = conj(d) * c;
  return std::abs(cross(first, second)) / (norm(first) * norm(second));
}

double least_distance(const std::vector<BurmesterCurves::Point>& points, const Vec2d& fixed) {
  double least = 1e300;
  for (const auto& point : points) {
    if (point.dyad.kind != DyadKind::pr) least = std::min(least, norm(point.dyad.fixed - fixed));
  }
  return least;
}

TEST(BurmesterCurves, SubtendEqualAngles) {
  Random random{std::mt19937_64(1)};
  for (int trial = 0; trial < 200; ++trial) {
    const auto poses = random_poses<4>(random);
    const BurmesterCurves curves(poses);
    ASSERT_EQ(curves.status(), GuidanceStatus::family);
    ASSERT_GE(curves.branch_count(), 1);
    ASSERT_LE(curves.branch_count(), 2);
    for (int branch = 0; branch < curves.branch_count(); ++branch) {
      for (int k = 0; k < 50; ++k) {
        const DyadSolutions found = curves.at(branch, k / 50.0);
        ASSERT_EQ(found.count, 1);
        const GuidingDyad& dyad = found.storage[0];
        const double size = 1 + (norm(dyad.in_body) + norm(dyad.fixed)) / extent(poses);
        EXPECT_LT(dyad.residual, 3e-15 * size * (1 + dyad.condition));
        if (dyad.kind == DyadKind::rr && dyad.condition < 1e4) {
          // Near a pole the angle under which its sides are seen is ill determined.
          double nearest = 1e300;
          for (const auto& [i, j] : {std::pair{0, 1}, {1, 2}, {2, 3}, {0, 3}}) {
            const Vec2d at = pole_of(poses, std::size_t(i), std::size_t(j));
            nearest = std::min(nearest, norm(at - dyad.fixed));
          }
          EXPECT_LT(angle_error(poses, dyad.fixed), 1e-11 * size * (1 + 1 / nearest));
        }
      }
    }
  }
}

/// All six poles are centre points, and so all six lie on the traced curve.
TEST(BurmesterCurves, PassThroughThePoles) {
  int tested = 0;
  Random random{std::mt19937_64(2)};
  for (int trial = 0; trial < 20; ++trial) {
    const auto poses = random_poses<4>(random);
    const BurmesterCurves curves(poses);
    std::vector<BurmesterCurves::Point> points;
    for (int branch = 0; branch < curves.branch_count(); ++branch) {
      const auto traced = curves.trace(branch, 0.05, 10, 100000);
      points.insert(points.end(), traced.begin(), traced.end());
    }
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = i + 1; j < 4; ++j) {
        const Vec2d at = pole_of(poses, i, j);
        if (norm(at - poses[0].at) > 9 * extent(poses)) continue;
        ++tested;
        EXPECT_LT(least_distance(points, at), 0.05 * extent(poses));
      }
    }
  }
  EXPECT_GE(tested, 100);
}

TEST(BurmesterCurves, AreTracedWithoutGaps) {
  Random random{std::mt19937_64(3)};
  for (int trial = 0; trial < 20; ++trial) {
    const auto poses = random_poses<4>(random);
    const BurmesterCurves curves(poses);
    const double size = extent(poses);
    for (int branch = 0; branch < curves.branch_count(); ++branch) {
      const auto points = curves.trace(branch, 0.05, 5);
      ASSERT_GT(points.size(), 40U);
      EXPECT_EQ(points.front().parameter, 0);
      EXPECT_EQ(points.back().parameter, 1);
      for (std::size_t k = 1; k < points.size(); ++k) {
        const GuidingDyad &a = points[k - 1].dyad, &b = points[k].dyad;
        EXPECT_LT(points[k - 1].parameter, points[k].parameter);
        if (norm(a.fixed - poses[0].at) < 5 * size && a.kind != DyadKind::pr) {
          EXPECT_LE(norm(a.fixed - b.fixed), 0.05 * size);
        }
        if (norm(a.moving - poses[0].at) < 5 * size && a.kind != DyadKind::rp) {
          EXPECT_LE(norm(a.moving - b.moving), 0.05 * size);
        }
      }
    }
  }
}

/// A dyad of five poses is on the curve of each four of them: found there again on a line through
/// its fixed pivot, and on one through its moving pivot.
TEST(BurmesterCurves, MeetInTheDyadsOfFivePoses) {
  Random random{std::mt19937_64(4)};
  int dyads = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const auto five = random_poses<5>(random);
    const DyadSolutions all = dyads_of_five_poses(five);
    for (const GuidingDyad& dyad : all.dyads()) {
      if (dyad.condition > 1e4) continue;
      ++dyads;
      for (const std::size_t omitted : {4U, 2U}) {
        const Poses poses = without(five, omitted);
        const BurmesterCurves curves(poses);
        const double angle = random(0, 3);
        const Vec2d along{std::cos(angle), std::sin(angle)};
        const auto nearest = [&](const DyadSolutions& found) {
          double least = 1e300;
          for (const GuidingDyad& other : found.dyads()) {
            least = std::min(least,
                             norm(other.fixed - dyad.fixed) + norm(other.in_body - dyad.in_body));
          }
          return least;
        };
        const double size = 1 + norm(dyad.fixed) + norm(dyad.in_body);
        EXPECT_LT(nearest(curves.with_fixed_pivot_on({dyad.fixed, along})), 1e-7 * size * size);
        EXPECT_LT(nearest(curves.with_moving_pivot_on({dyad.in_body, along})), 1e-7 * size * size);
      }
    }
  }
  EXPECT_GT(dyads, 200);
}

TEST(BurmesterCurves, EndInASliderAndABlock) {
  Random random{std::mt19937_64(5)};
  for (int trial = 0; trial < 500; ++trial) {
    const auto poses = random_poses<4>(random);
    const BurmesterCurves curves(poses);
    const DyadSolutions slider = curves.sliders(), block = curves.blocks();
    ASSERT_EQ(slider.count, 1);
    ASSERT_EQ(block.count, 1);
    EXPECT_EQ(slider.storage[0].kind, DyadKind::pr);
    EXPECT_EQ(block.storage[0].kind, DyadKind::rp);
    EXPECT_LT(slider.storage[0].residual, 2e-14);
    EXPECT_LT(block.storage[0].residual, 2e-14);
  }
}

/// The pose turned by `angle` about `centre`.
Pose turned(const Pose& pose, const Vec2d& centre, double angle) {
  const Vec2d turn{std::cos(angle), std::sin(angle)};
  return {centre + turn * (pose.at - centre), pose.angle + angle};
}

Poses poses_of(const Mechanism<double>& chain, int body) {
  MechanismMotion<0> motion(chain);
  Poses poses;
  for (std::size_t j = 0; j < 4; ++j) {
    EXPECT_TRUE(motion.move_to(std::array{0.5, 1.1, 1.9, 2.6}[j]));
    const Vec2d direction = motion.bodies()[static_cast<std::size_t>(body)].direction;
    poses[j] = {motion.point({body, {0.3, 0.4}})[0], std::atan2(direction.y, direction.x)};
  }
  return poses;
}

const Pose start{{0.3, 0.2}, 0.4};

/// Poses whose curves fall apart into lines, circles and hyperbolas, or have a node.
std::vector<Poses> special_poses() {
  const Pose second = turned(start, {2, 1}, 0.5), third = turned(second, {-1, 1}, 0.9);
  const EllipticTrammel trammel{{1, 2}, 3, {1, 0}, {0.6, 0.8}};
  const OldhamCoupling oldham{{0, 0}, {1, 0.5}, {0.6, 0.8}};
  const FourBar antiparallelogram{{0, 0}, {2, 0}, 1, 2, 1, Assembly::crossed, std::nullopt};
  return {
      // one pole at infinity, two, and three
      {start, {{1, 0.5}, 0.4}, {{1.5, -0.4}, 2}, {{-0.5, 0.8}, -0.7}},
      {start, {{1, 0.5}, 0.4}, {{1.5, -0.4}, 2}, {{-0.5, 0.8}, 2}},
      {start, {{1, 0.5}, 0.4}, {{1.5, -0.4}, 0.4}, {{-0.5, 0.8}, 2}},
      // three poses turned about one point, and two pairs, by equal angles or not
      {start, second, turned(second, {2, 1}, 0.6), {{-0.5, 0.8}, -0.7}},
      {start, second, third, turned(third, {2, 1}, 0.5)},
      {start, second, third, turned(third, {2, 1}, -0.8)},
      // half turns; mirror images of one another; equal steps
      {Pose{{0, 0}, 0}, {{1, 0}, kPi}, {{2, 1}, 0}, {{3, 0}, kPi}},
      {Pose{{-2, 0}, 0.6}, {{-1, 0.5}, 0.2}, {{1, 0.5}, -0.2}, {{2, 0}, -0.6}},
      {Pose{{0, 0}, 0}, {{1, 0}, 0.5}, {{2, 0}, 1}, {{3, 0}, 1.5}},
      poses_of(as_mechanism(trammel), 1),
      poses_of(as_mechanism(oldham), 3),
      poses_of(as_mechanism(antiparallelogram), 2),
  };
}

/// What a line meets is on the curve that was traced, dyad for dyad, so nothing of it is missing.
TEST(BurmesterCurves, AreWholeWhereTheyFallApart) {
  Random random{std::mt19937_64(6)};
  int number = 0;
  for (const Poses& poses : special_poses()) {
    const BurmesterCurves curves(poses);
    ASSERT_EQ(curves.status(), GuidanceStatus::family);
    const double size = extent(poses);
    std::vector<GuidingDyad> traced;
    for (int branch = 0; branch < curves.branch_count(); ++branch) {
      for (const auto& point : curves.trace(branch, 0.05, 10)) {
        // Pivots far away are rounded so much the more.
        const double far = (norm(point.dyad.in_body) + norm(point.dyad.fixed)) / size;
        EXPECT_LT(point.dyad.residual, 1e-14 * (1 + point.dyad.condition + far));
        EXPECT_TRUE(std::isfinite(norm(point.dyad.in_body) + norm(point.dyad.fixed)));
        traced.push_back(point.dyad);
      }
    }
    EXPECT_LT(traced.size(), 10000U);
    const auto gap = [&](const GuidingDyad& dyad) {
      double least = 1e300;
      for (const GuidingDyad& other : traced) {
        if (other.kind != dyad.kind) continue;
        const double fixed = norm(other.fixed - dyad.fixed);
        least = std::min(least, std::max(fixed, norm(other.moving - dyad.moving)));
      }
      return least;
    };
    int met = 0;
    for (int k = 0; k < 60; ++k) {
      const double angle = random(0, 3);
      const Line line{poses[0].at + size * random.vector(3), {std::cos(angle), std::sin(angle)}};
      const Line in_body{to_body(poses[0], line.point), line.direction};
      for (const DyadSolutions& found :
           {curves.with_fixed_pivot_on(line), curves.with_moving_pivot_on(in_body)}) {
        for (const GuidingDyad& dyad : found.dyads()) {
          EXPECT_LT(dyad.residual, 1e-9);
          const double away =
              std::max(norm(dyad.fixed - poses[0].at), norm(dyad.moving - poses[0].at));
          if (dyad.kind != DyadKind::rr || away > 9 * size) continue;
          ++met;
          EXPECT_LT(gap(dyad), 0.08 * size) << "poses " << number;
        }
      }
    }
    EXPECT_GT(met, 10) << "poses " << number;
    ++number;
  }
}

/// A trammel's link has a slider in every direction, Oldham's disc a block.
TEST(BurmesterCurves, FindFamiliesOfSlides) {
  const EllipticTrammel trammel{{1, 2}, 3, {1, 0}, {0.6, 0.8}};
  const BurmesterCurves sliding(poses_of(as_mechanism(trammel), 1));
  const DyadSolutions sliders = sliding.sliders();
  EXPECT_EQ(sliders.status, GuidanceStatus::family);
  ASSERT_EQ(sliders.count, 4);
  for (const GuidingDyad& dyad : sliders.dyads()) {
    EXPECT_EQ(dyad.kind, DyadKind::pr);
    EXPECT_LT(dyad.residual, 1e-14);
    // All slide lines pass through the centre.
    EXPECT_NEAR(cross(dyad.direction, trammel.centre - dyad.fixed), 0, 1e-12);
  }
  const OldhamCoupling oldham{{0, 0}, {1, 0.5}, {0.6, 0.8}};
  const DyadSolutions blocks = BurmesterCurves(poses_of(as_mechanism(oldham), 3)).blocks();
  EXPECT_EQ(blocks.status, GuidanceStatus::family);
  ASSERT_EQ(blocks.count, 4);
  for (const GuidingDyad& dyad : blocks.dyads()) EXPECT_EQ(dyad.kind, DyadKind::rp);
}

// Poses of a square, of a rectangle and mirrored about an axis: the cubics fall apart or are
// symmetric, and no point of theirs is without a number.
TEST(BurmesterCurves, OfSymmetricPosesAreNumbers) {
  constexpr double right = kRightAngle;
  const std::vector<Poses> cases{
      {{{{1, 1}, 0}, {{-1, 1}, right}, {{-1, -1}, 2 * right}, {{1, -1}, 3 * right}}},
      {{{{1, 1}, 0}, {{-1, 1}, -right}, {{-1, -1}, -2 * right}, {{1, -1}, -3 * right}}},
      {{{{1, 1}, 0}, {{-1, 1}, 2 * right}, {{-1, -1}, right}, {{1, -1}, 3 * right}}},
      {{{{2, 1}, 0.3}, {{-2, 1}, -0.3}, {{-2, -1}, 0.3}, {{2, -1}, -0.3}}},
      {{{{3, 0.5}, 0.7}, {{1, 0}, 0.2}, {{-1, 0}, -0.2}, {{-3, 0.5}, -0.7}}},
      {{{{3, 0}, 0.7}, {{1, 0}, 0.2}, {{-1, 0}, -0.2}, {{-3, 0}, -0.7}}},
      {{{{0, 3}, 0.5}, {{0, 1}, 0.5}, {{0, -1}, -0.5}, {{0, -3}, -0.5}}}};
  for (const Poses& poses : cases) {
    const BurmesterCurves curves(poses);
    for (int branch = 0; branch < curves.branch_count(); ++branch) {
      for (const auto& point : curves.trace(branch, 0.05, 10)) {
        const double farthest = std::max(norm(point.dyad.fixed), norm(point.dyad.moving));
        EXPECT_TRUE(farthest < 1e15) << branch << ' ' << point.parameter;
        EXPECT_TRUE(point.dyad.residual < 1e-6) << branch << ' ' << point.parameter;
      }
    }
  }
}

// Without a turn the links are parallel; on less than half a circle the frame is never along them.
TEST(BurmesterCurves, GiveAParallelogramAwayFromItsDeadPoints) {
  const Poses poses{{{{0, 0}, 0}, {{1, 1}, 0}, {{3, 1}, 0}, {{4, 0}, 0}}};
  const DyadSolutions found = BurmesterCurves(poses).examples();
  ASSERT_EQ(found.count, 2);
  const GuidingDyad &first = found.storage[0], &second = found.storage[1];
  const Vec2d frame = second.fixed - first.fixed;
  EXPECT_GT(std::abs(norm(frame) / first.length - 1), 0.1) << "no rhombus";
  int left = 0;
  for (const Pose& pose : poses) {
    const Vec2d link = to_frame(pose, first.in_body) - first.fixed;
    EXPECT_NEAR(norm(link), std::sqrt(5), 1e-14);
    EXPECT_GT(std::abs(cross(frame, link)), 0.3 * norm(frame) * norm(link));
    left += cross(frame, link) > 0 ? 1 : 0;
  }
  EXPECT_TRUE(left == 0 || left == 4);
}

TEST(BurmesterCurves, NameADegeneracy) {
  const auto expect_none = [](const Poses& poses, GuidanceStatus status, int examples) {
    const BurmesterCurves curves(poses);
    EXPECT_EQ(curves.status(), status);
    EXPECT_EQ(curves.branch_count(), 0);
    EXPECT_EQ(curves.examples().count, examples);
    EXPECT_EQ(curves.sliders().count, 0);
    EXPECT_EQ(curves.blocks().status, status);
    EXPECT_EQ(curves.with_fixed_pivot_on({}).status, status);
    EXPECT_EQ(curves.with_moving_pivot_on({}).count, 0);
  };
  const Poses scattered{start, {{1, 0.5}, 0.4}, {{1.5, -0.4}, 0.4}, {{-0.5, 0.8}, 0.4}};
  expect_none(scattered, GuidanceStatus::translation, 0);
  const Poses circle{Pose{{1, 0}, 0}, {{0, 1}, 0}, {{-1, 0}, 0}, {{0.6, -0.8}, 0}};
  expect_none(circle, GuidanceStatus::translation, 2);
  const Vec2d centre{2, 1};
  const Poses turns{start, turned(start, centre, 0.5), turned(start, centre, 1.7),
                    turned(start, centre, -1)};
  expect_none(turns, GuidanceStatus::rotation, 1);
  expect_none({start, scattered[1], start, circle[0]}, GuidanceStatus::coincident_poses, 0);
  expect_none({start, {{NAN, 0}, 0}, circle[1], circle[0]}, GuidanceStatus::not_finite, 0);
}

}  // namespace
}  // namespace cognate::synthesis::burmester_curves_test
