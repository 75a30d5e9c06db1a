/// Straight stretches, held against closed forms of circles and against search over samples.
#include "analysis/coupler_curve/straightness.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "analysis/linkage/four_bar.hpp"
#include "analysis/mechanism/joints.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::straightness_test {
namespace {

constexpr double pi = kPi;

Vec2d unit_vector(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

Path circle(double radius, const Vec2d& centre) {
  return [=](double q) {
    return PathPoint{centre + radius * unit_vector(q), radius * perp(unit_vector(q))};
  };
}

TEST(NarrowestStrip, IsNoWiderThanAnyOther) {
  std::mt19937_64 random(41);
  std::normal_distribution<double> place;
  StripFinder narrowest;
  for (int i = 0; i < 300; ++i) {
    std::vector<Vec2d> points(3 + random() % 40);
    for (Vec2d& point : points) point = {place(random), 1e-2 * place(random)};
    std::vector<Vec2d> sorted = points;
    const NarrowestStrip strip = narrowest(sorted);
    for (const Vec2d& point : points) {
      EXPECT_LE(std::abs(cross(strip.direction, point - strip.through)), strip.half_width + 1e-15);
    }
    EXPECT_NEAR(half_width_across(points, strip.direction), strip.half_width, 1e-15);
    for (int k = 0; k < 3000; ++k) {
      ASSERT_GE(half_width_across(points, unit_vector(pi * k / 3000)), strip.half_width - 1e-15);
    }
  }
}

/// The narrowest of the strips along the lines through any two points, by 113 bits.
double width_by_pairs(const std::vector<Vec2d>& points) {
  using Wide = __float128;
  Wide best = 1e30;
  for (const Vec2d& p : points) {
    for (const Vec2d& q : points) {
      const Wide x = Wide(q.x) - p.x, y = Wide(q.y) - p.y;
      if (x * x + y * y == 0) continue;
      Wide low = 0, high = 0;
      for (const Vec2d& other : points) {
        const Wide height = x * (Wide(other.y) - p.y) - y * (Wide(other.x) - p.x);
        low = std::min(low, height);
        high = std::max(high, height);
      }
      best = std::min(best, (high - low) / std::sqrt(static_cast<double>(x * x + y * y)));
    }
  }
  return static_cast<double>(best / 2);
}

/// Points of nearly straight curves crowd at the ends, and some differ from others by rounding
/// alone.
TEST(NarrowestStrip, OfPointsInLineButForLittle) {
  std::mt19937_64 random(43);
  std::uniform_real_distribution<double> part(-1, 1);
  StripFinder narrowest;
  for (int i = 0; i < 150; ++i) {
    const double size = std::pow(10, -8 + 5 * part(random)), slope = 3 * part(random);
    const double wave = 2 + 3 * std::abs(part(random)), phase = 3 * part(random);
    std::vector<Vec2d> points;
    for (int k = 0; k <= 32; ++k) {
      const double x = -std::cos(pi * k / 32), y = size * std::sin(wave * x + phase);
      points.push_back(Vec2d{x, y} * unit_vector(slope));
      if (k % 4 == i % 4) {
        const double near = i % 3 == 0 ? 1e-12 : 3e-16;
        points.push_back(points.back() + near * Vec2d{part(random), part(random)});
      }
    }
    std::vector<Vec2d> sorted = points;
    const double expected = width_by_pairs(points);
    EXPECT_NEAR(narrowest(sorted).half_width, expected, 1e-6 * expected + 1e-15) << i;
  }
}

TEST(NarrowestStrip, OfFewPoints) {
  StripFinder narrowest;
  std::vector<Vec2d> none, one{{1, 2}}, same(5, Vec2d{1, 2}), line{{0, 0}, {2, 1}, {4, 2}};
  EXPECT_EQ(narrowest(none).half_width, 0);
  EXPECT_EQ(narrowest(one).half_width, 0);
  EXPECT_EQ(narrowest(same).half_width, 0);
  EXPECT_NEAR(narrowest(line).half_width, 0, 1e-15);
}

TEST(Straightness, OfACircle) {
  for (const double radius : {1e-9, 1.0, 1e9}) {
    const Path path = circle(radius, {3 * radius, -radius});
    const StraightSegment half = measure(path, 0.2, 1.4);
    EXPECT_NEAR(half.length, 2 * radius * std::sin(0.6), 1e-12 * radius);
    EXPECT_NEAR(half.deviation, 0.5 * radius * (1 - std::cos(0.6)), 1e-12 * radius);
    const CrankRange forward = forward_interval(path, 0.8, {-20, 20}).value();
    EXPECT_NEAR(forward.from, 0.8 - 0.5 * pi, 1e-12);
    EXPECT_NEAR(forward.to, 0.8 + 0.5 * pi, 1e-12);
    for (const double relative : {1e-3, 1e-2}) {
      // (1 − cos α)/2 = relative·2 sin α, and 1 − cos α for the tangent.
      const double alpha = 2 * std::atan(4 * relative), beta = 2 * std::atan(2 * relative);
      const StraightSegment best = longest_segment(path, 0.8, forward, relative);
      EXPECT_NEAR(best.length, 2 * radius * std::sin(alpha), 1e-9 * radius);
      const StraightSegment tangent = longest_tangent_segment(path, 0.8, forward, relative);
      EXPECT_NEAR(tangent.length, 2 * radius * std::sin(beta), 1e-9 * radius);
    }
  }
}

TEST(Straightness, ASpeedThatIsConstantDoesNotVary) {
  const Path line = [](double q) { return PathPoint{{3 * q, 4 * q}, {3, 4}}; };
  const StraightSegment segment = measure(line, 1, 2);
  EXPECT_NEAR(segment.length, 5, 1e-14);
  EXPECT_NEAR(segment.deviation, 0, 1e-14);
  EXPECT_NEAR(speed_variation(line, segment).value(), 0, 1e-14);
  const Path faster = [](double q) { return PathPoint{{q * q, 0}, {2 * q, 0}}; };
  EXPECT_NEAR(speed_variation(faster, measure(faster, 1, 3)).value(), 1, 1e-12);
}

TEST(Straightness, EndsWhereTheMotionDoes) {
  // A triple rocker: its crank turns back at a dead point.
  const FourBar linkage{{0, 0}, {3, 0}, 2, 1.2, 2.5, Assembly::open, Vec2d{0.5, 0.4}};
  const Path path = path_of(as_mechanism(linkage), {2, *linkage.coupler_point});
  const auto ranges = crank_ranges(lengths(linkage));
  ASSERT_EQ(ranges.size(), 2U);
  const double middle = 0.5 * (ranges[0].from + ranges[0].to);
  const auto forward = forward_interval(path, middle, ranges[0]);
  ASSERT_TRUE(forward);
  EXPECT_GE(forward->from, ranges[0].from);
  EXPECT_LE(forward->to, ranges[0].to);
  const StraightSegment segment = longest_segment(path, middle, *forward, 0.05);
  EXPECT_GT(segment.length, 0);
  EXPECT_TRUE(std::isfinite(segment.deviation));
  EXPECT_FALSE(forward_interval(path, ranges[0].to + 1, ranges[0]));
}

}  // namespace
}  // namespace cognate::straightness_test
