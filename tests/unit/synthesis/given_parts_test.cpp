// Given parts as equations, and what they and poses leave of a solution's residual.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <random>
#include <string>

#include "synthesis/exact/nine_point/constrained_path.hpp"
#include "synthesis/exact/nine_point/constrained_tracker.hpp"
#include "synthesis/exact/nine_point/fixed_parts.hpp"
#include "synthesis/exact/nine_point/generic_set.hpp"
#include "tests/support/planted_path.hpp"

namespace cognate::synthesis::given_parts_test {
namespace {

using Complex = std::complex<double>;

Complex complex_of(const Vec2d& v) {
  return {v.x, v.y};
}

/// The equation that conjugates of solutions satisfy.
SideCondition conjugate(const SideCondition& condition) {
  SideCondition image = condition;
  for (std::size_t i = 0; i < image.linear.size(); ++i) {
    image.linear[i] = std::conj(condition.linear[i ^ 1]);
  }
  image.value = std::conj(condition.value);
  return image;
}

/// Whether two equations are the same to the last digit, but for their signs.
bool are_equal(const SideCondition& a, const SideCondition& b) {
  const auto same = [&](double sign) {
    for (std::size_t i = 0; i < a.linear.size(); ++i) {
      if (a.linear[i] != sign * b.linear[i]) return false;
    }
    return a.value == sign * b.value;
  };
  return a.from == b.from && a.to == b.to && (same(1) || (a.from < 0 && same(-1)));
}

/// Certificates of reality are true only if conjugation carries solutions into solutions exactly.
TEST(FixedParts, OfTheRealPlaneAreClosedUnderConjugation) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> any(-3, 3);
  for (int i = 0; i < 100; ++i) {
    PathSystem system;
    system.origin = {any(random), any(random)};
    system.scale = std::abs(any(random));
    const FixedParts parts{.pivot_a = Vec2d{any(random), any(random)},
                           .coupler_point = Vec2d{any(random), any(random)},
                           .frame_angle = any(random),
                           .crank = 0.7,
                           .coupler = 1.1,
                           .rocker = 0.9};
    const auto conditions = side_conditions(parts, system);
    ASSERT_EQ(int(conditions.size()), condition_count(parts));
    for (const SideCondition& condition : conditions) {
      EXPECT_TRUE(std::ranges::any_of(
          conditions,
          [&](const SideCondition& other) { return are_equal(conjugate(condition), other); }))
          << "frame angle " << *parts.frame_angle;
    }
  }
}

/// A linkage as a solution of its own positions, all of them poses.
struct PlantedPoses {
  constrained::State state;
  constrained::Data data;
};

PlantedPoses planted_poses(std::mt19937_64& random, int count) {
<<<<<<< HEAD
  const auto planted = planting::random_crank_rocker(random, count, 0.9);
=======
  const auto planted = test::random_crank_rocker(random, count, 0.9);
>>>>>>> 4d5ca09
  const Motion motion(planted.linkage);
  PlantedPoses result;
  cognate::Pose first;
  for (const double angle : planted.crank_angles) {
    const cognate::Pose pose = motion.at(angle).value();
    if (angle == planted.crank_angles[0]) {
      first = pose;
      continue;
    }
    const Complex turn = complex_of(pose.c - pose.b) / complex_of(first.c - first.b);
    result.data.t.push_back(turn / std::abs(turn));
    result.data.d.push_back(complex_of(*pose.coupler_point - *first.coupler_point));
    result.data.d_bar.push_back(std::conj(result.data.d.back()));
  }
  const Vec2d& at = *first.coupler_point;
  const Vec2d pivots[] = {first.b - at, planted.linkage.pivot_a - at, first.c - at,
                          planted.linkage.pivot_d - at};
  for (std::size_t i = 0; i < 4; ++i) {
    result.state.pivots[2 * i] = complex_of(pivots[i]);
    result.state.pivots[2 * i + 1] = std::conj(complex_of(pivots[i]));
  }
  return result;
}

/// Where its coupler has a given orientation, a linkage puts its point in one place alone.
TEST(Residual, IsTheDistanceFromThePoseThatIsMissed) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> direction(-3, 3);
  for (int i = 0; i < 50; ++i) {
    PlantedPoses planted = planted_poses(random, 5);
    constexpr double kMoved = 1e-7;
    const Complex by = std::polar(kMoved, direction(random));
    planted.data.d[2] += by;
    planted.data.d_bar[2] += std::conj(by);
    EXPECT_NEAR(constrained::quality(planted.state, planted.data).residual, kMoved, 1e-3 * kMoved);
  }
}

TEST(Residual, IsNoNumberWhereOnePositionHasNone) {
  std::mt19937_64 random(5);
  for (std::size_t j = 0; j < 4; ++j) {
    PlantedPoses planted = planted_poses(random, 5);
    planted.data.d[j] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(std::isnan(constrained::quality(planted.state, planted.data).residual)) << j;
  }
}

TEST(GenericSet, IsKeptInAFolder) {
  const auto folder =
      std::filesystem::temp_directory_path() / ("cognate-generic-" + std::to_string(getpid()));
  const PathClass kind{2, 1};
  const FixedParts given{.pivot_a = Vec2d{}, .pivot_d = Vec2d{}, .crank = 1};
  EXPECT_FALSE(constrained::read_generic_set(folder, kind, given));
  const auto set = constrained::generic_set(kind, given, {.cache = folder});
  ASSERT_TRUE(set);
  EXPECT_TRUE(set->settled);
  const auto read = constrained::read_generic_set(folder, kind, given);
  ASSERT_TRUE(read);
  ASSERT_EQ(read->states.size(), set->states.size());
  EXPECT_EQ(read->data.d, set->data.d);
  for (std::size_t i = 0; i < set->states.size(); ++i) {
    EXPECT_EQ(read->states[i].pivots, set->states[i].pivots);
    EXPECT_EQ(read->states[i].log_t, set->states[i].log_t);
  }
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    std::filesystem::resize_file(entry.path(), std::filesystem::file_size(entry.path()) - 8);
  }
  EXPECT_FALSE(constrained::read_generic_set(folder, kind, given));
  std::filesystem::remove_all(folder);
}

/// Four poses determine a dyad, as three and a fixed pivot do.
TEST(Conditions, AreDependentWhereOneDyadHasMoreThanFour) {
  EXPECT_TRUE(are_independent({4, 0}, {.crank = 1, .rocker = 1}));
  EXPECT_TRUE(are_independent({3, 0}, {.pivot_a = Vec2d{}, .pivot_d = Vec2d{}}));
  EXPECT_TRUE(are_independent({1, 4}, {.pivot_a = Vec2d{}, .pivot_d = Vec2d{}}));
  EXPECT_FALSE(are_independent({4, 0}, {.pivot_a = Vec2d{}}));
  EXPECT_FALSE(are_independent({3, 0}, {.pivot_a = Vec2d{}, .crank = 1}));
  EXPECT_FALSE(are_independent({3, 1}, {.pivot_d = Vec2d{}, .rocker = 1}));
}

}  // namespace
}  // namespace cognate::synthesis::given_parts_test
