/// The nearest point of half planes against known points and against all feet and corners.
#include "synthesis/exact/cam/half_planes.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "analysis/numbers/constants.hpp"

namespace cognate::half_planes_test {
namespace {

using synthesis::HalfPlane;
using synthesis::nearest_point;

using Wide = long double;
using WidePoint = Vec2<Wide>;

double draw(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

WidePoint wide(const Vec2d& a) {
  return {a.x, a.y};
}

/// Least distance from `centre` of all feet and corners, and of `centre` itself, that are in every
/// half plane; infinite where none is.
Wide least_distance(const Vec2d& centre, const std::vector<HalfPlane>& planes) {
  std::vector<WidePoint> candidates{wide(centre)};
  for (const HalfPlane& a : planes) {
    const WidePoint n = wide(a.normal);
    candidates.push_back(wide(centre) + ((a.bound - dot(n, wide(centre))) / dot(n, n)) * n);
    for (const HalfPlane& b : planes) {
      const WidePoint m = wide(b.normal);
      const Wide turn = cross(n, m);
      if (turn == 0) continue;
      candidates.push_back({(a.bound * m.y - b.bound * n.y) / turn,  //
                            (b.bound * n.x - a.bound * m.x) / turn});
    }
  }
  Wide least = std::numeric_limits<Wide>::infinity();
  for (const WidePoint& point : candidates) {
    const bool inside = std::ranges::all_of(planes, [&](const HalfPlane& plane) {
      return dot(wide(plane.normal), point) >= plane.bound - 1e-13L * (1 + std::abs(plane.bound));
    });
    const WidePoint from = point - wide(centre);
    if (inside) least = std::min(least, std::hypot(from.x, from.y));
  }
  return least;
}

/// The point found is as near as the nearest of all feet and corners, is inside, and what binds it
/// forces it alone.
void expect_nearest(const Vec2d& centre, const std::vector<HalfPlane>& planes, double tolerance) {
  const auto found = nearest_point(centre, planes);
  ASSERT_TRUE(found);
  const auto least = static_cast<double>(least_distance(centre, planes));
  const double scale = 1 + norm(centre) + least;
  EXPECT_NEAR(found->distance, least, tolerance * scale);
  EXPECT_NEAR(norm(found->at - centre), least, tolerance * scale);
  for (const HalfPlane& plane : planes) {
    const double missing = plane.bound - dot(plane.normal, found->at);
    EXPECT_LE(missing, tolerance * scale * norm(plane.normal));
  }
  ASSERT_LE(found->binding.size(), 2);
  std::vector<HalfPlane> binding;
  for (const std::size_t i : found->binding) binding.push_back(planes.at(i));
  EXPECT_NEAR(static_cast<double>(least_distance(centre, binding)), least, tolerance * scale);
}

TEST(NearestPoint, OfNothingOneOrNoneActiveIsKnown) {
  const auto all = nearest_point({3, -2}, {});
  ASSERT_TRUE(all);
  EXPECT_EQ(all->at, (Vec2d{3, -2}));
  EXPECT_EQ(all->distance, 0);
  EXPECT_TRUE(all->binding.empty());

  // 3x + 4y ≥ 10 from (0, 0): the foot is (6, 8)/5.
  const auto foot = nearest_point({0, 0}, std::vector<HalfPlane>{{{3, 4}, 10}});
  ASSERT_TRUE(foot);
  EXPECT_NEAR(foot->at.x, 1.2, 1e-15);
  EXPECT_NEAR(foot->at.y, 1.6, 1e-15);
  EXPECT_NEAR(foot->distance, 2, 1e-15);
  EXPECT_EQ(foot->binding, (std::vector<std::size_t>{0}));

  const std::vector<HalfPlane> square{{{1, 0}, -1}, {{-2, 0}, -2}, {{0, 1}, -1}, {{0, -5}, -5}};
  const auto inside = nearest_point({0.5, -0.25}, square);
  ASSERT_TRUE(inside);
  EXPECT_EQ(inside->at, (Vec2d{0.5, -0.25}));
  EXPECT_TRUE(inside->binding.empty());
}

TEST(NearestPoint, OfTwoIsTheirVertexOrTheFootOfOne) {
  // 2x + y ≥ 10 and y ≥ 4 meet in (3, 4), which lies between their normals.
  const auto vertex = nearest_point({0, 0}, std::vector<HalfPlane>{{{2, 1}, 10}, {{0, 1}, 4}});
  ASSERT_TRUE(vertex);
  EXPECT_NEAR(vertex->at.x, 3, 1e-14);
  EXPECT_NEAR(vertex->at.y, 4, 1e-14);
  EXPECT_NEAR(vertex->distance, 5, 1e-14);
  EXPECT_EQ(vertex->binding, (std::vector<std::size_t>{0, 1}));

  // A bound that the centre keeps binds where the foot of the other breaks it: x ≥ 2 and
  // x + y ≤ 1.
  const auto pushed = nearest_point({0, 0}, std::vector<HalfPlane>{{{1, 0}, 2}, {{-1, -1}, -1}});
  ASSERT_TRUE(pushed);
  EXPECT_NEAR(pushed->at.x, 2, 1e-14);
  EXPECT_NEAR(pushed->at.y, -1, 1e-14);

  // Of parallel ones the farther.
  const auto farther = nearest_point({0, 1}, std::vector<HalfPlane>{{{0, 1}, 3}, {{0, 4}, 20}});
  ASSERT_TRUE(farther);
  EXPECT_EQ(farther->at, (Vec2d{0, 5}));
  EXPECT_EQ(farther->binding, (std::vector<std::size_t>{1}));
}

TEST(NearestPoint, OfOppositeOnesIsInTheirStripOrNowhere) {
  for (const Vec2d& normal : {Vec2d{1, 0}, Vec2d{0.6, 0.8}, Vec2d{0.3, -0.7}}) {
    const auto between = [&](double low, double high) {
      return nearest_point({0, 0}, std::vector<HalfPlane>{{normal, low}, {-normal, -high}});
    };
    const double length = norm(normal);
    const auto strip = between(2, 3);
    ASSERT_TRUE(strip);
    EXPECT_NEAR(strip->distance, 2 / length, 1e-15 * 2 / length);
    EXPECT_EQ(strip->binding, (std::vector<std::size_t>{0}));
    const auto behind = between(-3, -2);
    ASSERT_TRUE(behind);
    EXPECT_NEAR(behind->distance, 2 / length, 1e-15 * 2 / length);
    EXPECT_EQ(behind->binding, (std::vector<std::size_t>{1}));
    for (const double given : {2.0, -2.0, 0.1, 1e-9, 0.0}) {
      const auto line = between(given, given);
      ASSERT_TRUE(line) << given;
      EXPECT_NEAR(line->distance, std::abs(given) / length, 1e-15 * line->distance);
    }
    EXPECT_FALSE(between(3, 2));
    EXPECT_FALSE(between(-2, -3));
    EXPECT_FALSE(between(1, -1));
  }
}

TEST(NearestPoint, OfOneTwiceIsItsFoot) {
  std::mt19937_64 random(4);
  for (int i = 0; i < 300; ++i) {
    const Vec2d normal{draw(random, -1, 1), draw(random, -1, 1)};
    const double bound = draw(random, 0.1, 10), scale = draw(random, 0.1, 10);
    const double foot = bound / norm(normal);
    for (const double k : {1.0, scale}) {
      const auto found =
          nearest_point({0, 0}, std::vector<HalfPlane>{{normal, bound}, {k * normal, k * bound}});
      ASSERT_TRUE(found);
      EXPECT_NEAR(found->distance, foot, 1e-15 * foot);
    }
    const auto line =
        nearest_point({0, 0}, std::vector<HalfPlane>{{normal, bound}, {-normal, -bound}});
    ASSERT_TRUE(line);
    EXPECT_NEAR(line->distance, foot, 1e-15 * foot);
  }
}

TEST(NearestPoint, OfNearlyParallelOnesKeepsItsDistance) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 300; ++i) {
    const double angle = draw(random, 0, 6), size = draw(random, 0.1, 10);
    const double apart = 1e-9 * draw(random, 0.5, 2);
    const Vec2d a{std::cos(angle), std::sin(angle)};
    const Vec2d b{std::cos(angle + apart), std::sin(angle + apart)};
    expect_nearest({0, 0}, {{a, size}, {b, size}}, 1e-13);
    expect_nearest({0, 0}, {{a, size}, {b, draw(random, 0.1, 10)}}, 1e-13);
  }
  // y ≥ 1 and x ≥ 1e9 y.
  const auto far = nearest_point({0, 0}, std::vector<HalfPlane>{{{0, 1}, 1}, {{1e-9, -1}, 0}});
  ASSERT_TRUE(far);
  EXPECT_NEAR(far->distance, 1e9, 1e-6 * 1e9);
}

TEST(NearestPoint, OfManyAgreesWithAllFeetAndCorners) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 400; ++i) {
    const Vec2d common{draw(random, -5, 5), draw(random, -5, 5)};
    const Vec2d centre{draw(random, -5, 5), draw(random, -5, 5)};
    std::vector<HalfPlane> planes(3 + random() % 28);
    for (HalfPlane& plane : planes) {
      const double angle = draw(random, 0, kTurn), size = draw(random, 0.1, 10);
      plane.normal = {size * std::cos(angle), size * std::sin(angle)};
      plane.bound = dot(plane.normal, common) - size * draw(random, 0.01, 3);
    }
    expect_nearest(centre, planes, 1e-11);
  }
}

// Bounds through one point, parallel ones and the same ones in other scales; what is opposite has
// room between.
TEST(NearestPoint, OfManyOnAGridAgreesWithAllFeetAndCorners) {
  std::mt19937_64 random(3);
  const auto whole = [&](int most) {
    return static_cast<double>(static_cast<int>(random() % (2 * most + 1)) - most);
  };
  for (int i = 0; i < 400; ++i) {
    const Vec2d common{whole(4), whole(4)}, centre{whole(4), whole(4)};
    std::vector<HalfPlane> planes;
    for (std::size_t count = 3 + random() % 10; planes.size() < count;) {
      const Vec2d normal{whole(3), whole(3)};
      if (normal == Vec2d{}) continue;
      const bool ahead = normal.y > 0 || (normal.y == 0 && normal.x > 0);
      const auto room = static_cast<double>(ahead ? random() % 3 : 1 + random() % 2);
      planes.push_back({normal, dot(normal, common) - room});
    }
    SCOPED_TRACE(i);
    expect_nearest(centre, planes, 1e-12);
  }
}

}  // namespace
}  // namespace cognate::half_planes_test
