/// Crank-rockers from the rocker's angle at a limit: an exercise by hand, planted linkages, walks
/// along the arcs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "analysis/linkage/motion.hpp"
#include "analysis/numbers/constants.hpp"
#include "synthesis/exact/quick_return/limit_angle.hpp"

namespace cognate::synthesis::quick_return_limit_angle_test {
namespace {

constexpr double pi = kPi;
constexpr double degree = pi / 180;

[[nodiscard]] bool has(const RockerSolutions& found, const Lengths<double>& links,
                       double tolerance) {
  const double size = links.coupler + links.frame;
  return std::ranges::any_of(found.designs, [&](const QuickReturnRocker& design) {
    const Lengths<double> own = lengths(design.linkage);
    const double off =
        std::max({std::abs(own.crank - links.crank), std::abs(own.coupler - links.coupler),
                  std::abs(own.frame - links.frame)});
    return off <= tolerance * design.condition * size;
  });
}

/// A crank-rocker at random, its time ratio and the rocker's angles at its limits.
struct Planted {
  Lengths<double> links;
  double time_ratio, outer, inner;
};

std::optional<Planted> plant(std::mt19937_64& random, double unit) {
  std::uniform_real_distribution<double> length(0.1, 3);
  const Lengths<double> links{0.3 * length(random) * unit, length(random) * unit,
                              length(random) * unit, length(random) * unit};
  if (!crank_rotates(links) || mobility_class(links) != MobilityClass::crank_rocker ||
      grashof_excess(links) > -1e-3) {
    return std::nullopt;
  }
  const auto outer = outer_limit(links), inner = inner_limit(links);
  const auto ratio = time_ratio(links);
  if (!outer || !inner || !ratio) return std::nullopt;
  return Planted{links, *ratio, outer->rocker_angle, inner->rocker_angle};
}

TEST(QuickReturnLimitAngle, RecoversPlantedLinkages) {
  std::mt19937_64 random(20261127);
  std::uniform_real_distribution<double> exponent(-12, 12);
  constexpr double tolerance = 2e-14;
  int planted = 0, swing = 0, frame = 0;
  while (planted < 2000) {
    const auto one = plant(random, std::pow(10, exponent(random)));
    if (!one) continue;
    ++planted;
    const RockerTask task{one->time_ratio, one->links.rocker, one->inner - one->outer};
    const RockerFrameTask by_frame{one->time_ratio, one->links.rocker, one->links.frame};
    for (const RockerLimitAngle& given : {RockerLimitAngle{RockerLimit::outer, one->outer},
                                          RockerLimitAngle{RockerLimit::inner, one->inner}}) {
      const auto with_swing = rockers_at_limit(task, given);
      const auto with_frame = rockers_with_frame_at_limit(by_frame, given);
      swing += has(with_swing, one->links, tolerance);
      frame += has(with_frame, one->links, tolerance);
      for (const auto* found : {&with_swing, &with_frame}) {
        for (const QuickReturnRocker& design : found->designs) {
          const auto links = lengths(design.linkage);
          EXPECT_EQ(mobility_class(links), MobilityClass::crank_rocker);
          const auto limit =
              given.limit == RockerLimit::outer ? outer_limit(links) : inner_limit(links);
          EXPECT_NEAR(limit->rocker_angle, given.angle, 1e-9 * design.condition);
          EXPECT_GE(design.condition, 1);
        }
      }
    }
  }
  EXPECT_EQ(swing, 4000);
  EXPECT_EQ(frame, 4000);
}

/// As it moves: the crank's turn between the rocker's turning points, and the angle at them, by
/// samples of the closure.
TEST(QuickReturnLimitAngle, MovesAsItSays) {
  int tested = 0;
  const auto found =
      rockers_with_frame_at_limit({1.5, 75, 100}, {RockerLimit::inner, 135 * degree});
  for (const QuickReturnRocker& design : found.designs) {
    const Motion motion(design.linkage);
    const auto outer = motion.at(design.outer), inner = motion.at(design.inner);
    ASSERT_TRUE(outer && inner);
    const Vec2d frame = -1.0 * design.linkage.pivot_a;  // D is the origin
    const double angle = std::atan2(cross(frame, inner->c), dot(frame, inner->c));
    EXPECT_NEAR(std::abs(angle) / degree, 135, 1e-11);
    const double turn = std::abs(std::remainder(design.outer - design.inner, 2 * pi));
    EXPECT_NEAR((2 * pi - turn) / turn, 1.5, 1e-12);
    EXPECT_NEAR(norm(outer->c - design.linkage.pivot_a),
                design.linkage.crank + design.linkage.coupler, 1e-10);
    ++tested;
  }
  EXPECT_EQ(tested, 2);  // and its mirror image
}

// A usual exercise: rocker 75, frame 100, K = 1.5, the rocker at 45° to the frame at a limit. By
// the law of cosines AC₁ = 70.84; the line from A at 36° to it meets the rocker's circle at 169.47
// and 25.82 from A, so that AC₁ is the folded or the extended limit.
TEST(QuickReturnLimitAngle, ExerciseByHand) {
  const double known = std::sqrt(100 * 100 + 75 * 75 - 2 * 100 * 75 * std::cos(pi / 4));
  const double direction = std::asin(75 * std::sin(pi / 4) / known) - 36 * degree;
  const double foot = 100 * std::cos(direction);
  const double half = std::sqrt(foot * foot - (100 * 100 - 75 * 75));
  const double far = foot + half, near = foot - half;
  EXPECT_NEAR(far, 169.47, 0.01);
  EXPECT_NEAR(near, 25.82, 0.01);
  const RockerFrameTask task{1.5, 75, 100};
  const auto folded = rockers_with_frame_at_limit(task, {RockerLimit::inner, 135 * degree});
  const auto extended = rockers_with_frame_at_limit(task, {RockerLimit::outer, 135 * degree});
  ASSERT_EQ(folded.designs.size(), 2U);
  ASSERT_EQ(extended.designs.size(), 2U);
  EXPECT_TRUE(has(folded, {0.5 * (far - known), 0.5 * (far + known), 75, 100}, 1e-15));
  EXPECT_TRUE(has(extended, {0.5 * (known - near), 0.5 * (known + near), 75, 100}, 1e-15));
  EXPECT_FALSE(folded.designs[0].mirror);
  EXPECT_TRUE(folded.designs[1].mirror);
}

double angle_of(const Lengths<double>& links, RockerLimit limit) {
  const auto at = limit == RockerLimit::outer ? outer_limit(links) : inner_limit(links);
  return at ? at->rocker_angle : std::nan("");
}

/// How often the angle at a limit passes a value along a walk in small steps.
int crossings(const std::vector<RockerFamilyPoint>& walk, const RockerLimitAngle& given) {
  int count = 0;
  std::optional<double> before;
  for (const RockerFamilyPoint& point : walk) {
    const double off = angle_of(point.links, given.limit) - given.angle;
    if (before && (*before > 0) != (off > 0)) ++count;
    before = off;
  }
  return count;
}

TEST(QuickReturnLimitAngle, FindsAllThatAWalkMeets) {
  std::mt19937_64 random(77);
  std::uniform_real_distribution<double> swing(0.1, 2.4), ratio(1.02, 2.6), part(0.03, 0.97);
  int tested = 0, twice = 0;
  for (int i = 0; i < 300; ++i) {
    const RockerTask task{ratio(random), 3, swing(random)};
    const auto limit = i % 2 == 0 ? RockerLimit::outer : RockerLimit::inner;
    for (const PivotArc arc : {PivotArc::near, PivotArc::far}) {
      const auto range = limit_angle_range(task, arc, limit);
      ASSERT_EQ(range.has_value(), arc_limits(task, arc).has_value());
      if (!range) continue;
      const RockerLimitAngle given{limit, std::lerp(range->min, range->max, part(random))};
      const auto found = rockers_at_limit(task, given);
      // The walk ends a step before the arc does, where the crank vanishes.
      const auto walk = rocker_family(task, arc, {}, 3000);
      const auto count = std::ranges::count_if(found.designs, [&](const auto& design) {
        const double coupler = design.linkage.coupler;
        return design.arc == arc && !design.mirror && coupler > walk.front().links.coupler &&
               coupler < walk.back().links.coupler;
      });
      EXPECT_EQ(count, crossings(walk, given)) << i << ' ' << int(arc);
      ++tested;
      twice += count == 2;
    }
  }
  EXPECT_GT(tested, 450);
  EXPECT_GT(twice, 100);
}

TEST(QuickReturnLimitAngle, FindsNothingBeyondTheRange) {
  std::mt19937_64 random(78);
  std::uniform_real_distribution<double> swing(0.1, 2.4), ratio(1.02, 2.6);
  int tested = 0;
  for (int i = 0; i < 400; ++i) {
    const RockerTask task{i % 10 == 0 ? 1 : ratio(random), 3, swing(random)};
    for (const auto limit : {RockerLimit::outer, RockerLimit::inner}) {
      for (const PivotArc arc : {PivotArc::near, PivotArc::far}) {
        const auto range = limit_angle_range(task, arc, limit);
        if (!range || (arc == PivotArc::far && task.time_ratio == 1)) continue;
        const auto count = [&](double angle) {
          const auto found = rockers_at_limit(task, {limit, angle});
          return std::ranges::count(found.designs, arc, &QuickReturnRocker::arc);
        };
        const double room = range->max - range->min;
        if (room < 1e-2) continue;
        EXPECT_GE(count(range->min + 1e-3 * room), 2) << i;
        EXPECT_GE(count(range->max - 1e-3 * room), 2) << i;
        EXPECT_EQ(count(range->min - 1e-6 * room), 0) << i;
        EXPECT_EQ(count(range->max + 1e-6 * room), 0) << i;
        ++tested;
      }
    }
  }
  EXPECT_GT(tested, 1000);
}

// Half the swing as θ: D lies on the near circle; nothing is singular but the end of the arc.
TEST(QuickReturnLimitAngle, SwingOfTheta) {
  const double theta = 30 * degree;
  const RockerTask task{(pi + theta) / (pi - theta), 2, theta};
  const auto range = limit_angle_range(task, PivotArc::near, RockerLimit::outer);
  ASSERT_TRUE(range);
  EXPECT_NEAR(range->min, pi / 2 - theta / 2, 1e-7);
  const auto found = rockers_at_limit(task, {RockerLimit::outer, range->min + 0.2});
  EXPECT_EQ(std::ranges::count(found.designs, PivotArc::near, &QuickReturnRocker::arc), 2);
  for (const double bad : {0.0, -1.0, pi, 4.0}) {
    EXPECT_TRUE(rockers_at_limit(task, {RockerLimit::outer, bad}).designs.empty());
    EXPECT_TRUE(
        rockers_with_frame_at_limit({1.2, 2, 3}, {RockerLimit::inner, bad}).designs.empty());
  }
}

// Without a quick return A lies on C₁C₂'s line: between the two the crank would have no length.
TEST(QuickReturnLimitAngle, EqualTimesNeverNeedACrankOfNoLength) {
  std::mt19937_64 random(11);
  int found = 0;
  for (int i = 0; i < 3000; ++i) {
    const double rocker = std::uniform_real_distribution(10.0, 100.0)(random);
    const double frame = rocker * std::uniform_real_distribution(0.8, 2.0)(random);
    const double angle = std::round(std::uniform_real_distribution(1.0, 179.0)(random)) * degree;
    for (const RockerLimit limit : {RockerLimit::outer, RockerLimit::inner}) {
      for (const auto& design :
           rockers_with_frame_at_limit({1, rocker, frame}, {limit, angle}).designs) {
        const Lengths<double> links = lengths(design.linkage);
        EXPECT_GT(links.crank, 1e-9 * rocker) << rocker << ' ' << frame << ' ' << angle;
        EXPECT_NEAR(links.frame, frame, 1e-6 * frame);
        ++found;
      }
    }
  }
  EXPECT_GT(found, 500);
}

}  // namespace
}  // namespace cognate::synthesis::quick_return_limit_angle_test
