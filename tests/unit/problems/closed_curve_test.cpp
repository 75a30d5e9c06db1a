/// Closed polylines: lengths and places known by hand, distances against every side one by one.
#include "problems/path/curve/closed_curve.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "analysis/numbers/constants.hpp"

namespace cognate::problems::closed_curve_test {
namespace {

TEST(ClosedCurve, StepsAlongASquareAreEqual) {
  const ClosedCurve square({{0, 0}, {2, 0}, {2, 2}, {0, 2}});
  EXPECT_DOUBLE_EQ(square.length(), 8);
  const std::vector<Vec2d> wanted{{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};
  const auto points = square.equally_spaced(8);
  ASSERT_EQ(points.size(), wanted.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(norm(points[i] - wanted[i]), 0, 1e-15) << i;
  }
}

TEST(ClosedCurve, VerticesHoweverUnevenDoNotShiftSamples) {
  // A circle whose vertices crowd on one side.
  std::vector<Vec2d> vertices;
  constexpr int kVertices = 3000;
  for (int i = 0; i < kVertices; ++i) {
    const double angle = kTurn * std::pow(double(i) / kVertices, 2);
    vertices.push_back({std::cos(angle), std::sin(angle)});
  }
  const ClosedCurve circle(vertices);
  EXPECT_NEAR(circle.length(), kTurn, 1e-5);
  const auto points = circle.equally_spaced(7);
  for (int k = 0; k < 7; ++k) {
    const double angle = kTurn * k / 7;
    EXPECT_NEAR(norm(points[k] - Vec2d{std::cos(angle), std::sin(angle)}), 0, 1e-5) << k;
  }
}

/// Distance to the segment by its three cases, ends and foot of the perpendicular.
double distance_to_side(const Vec2d& p, const Vec2d& a, const Vec2d& b) {
  if (dot(p - a, b - a) <= 0) return norm(p - a);
  if (dot(p - b, a - b) <= 0) return norm(p - b);
  return std::abs(cross(b - a, p - a)) / norm(b - a);
}

TEST(ClosedCurve, DistancesAreThoseToTheNearestSide) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (const int count : {2, 3, 8, 9, 17, 100}) {
    std::vector<Vec2d> vertices;
    for (int i = 0; i < count; ++i) vertices.push_back({uniform(random), 3 * uniform(random)});
    const ClosedCurve curve(vertices);
    for (int trial = 0; trial < 200; ++trial) {
      const Vec2d p{2 * uniform(random), 4 * uniform(random)};
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i < vertices.size(); ++i) {
        const Vec2d& next = vertices[(i + 1) % vertices.size()];
        least = std::min(least, distance_to_side(p, vertices[i], next));
      }
      EXPECT_NEAR(curve.distance(p), least, 1e-14) << count << " vertices, " << p.x << " " << p.y;
    }
  }
}

}  // namespace
}  // namespace cognate::problems::closed_curve_test
