/// The assembly ranges of a motion against closed forms: ranges, change points, ends.
#include "analysis/mechanism/assembly_ranges.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/linkage/four_bar.hpp"
#include "analysis/linkage/mobility.hpp"
#include "analysis/mechanism/followed_motion.hpp"
#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "tests/support/random_chains.hpp"

namespace cognate::assembly_ranges_test {
namespace {

FourBar four_bar(const Lengths<double>& links, Assembly assembly = Assembly::open) {
  return {{0, 0}, {links.frame, 0}, links.crank, links.coupler, links.rocker, assembly, {}};
}

/// The ranges of random four-bars of all classes are those of the closed form, to rounding over
/// how steeply the discriminant leaves zero.
TEST(AssemblyRanges, RangesOfFourBarsAreTheClosedForm) {
  test::ChainMaker random(11);
  std::array<int, 3> seen{};
  for (int i = 0; i < 300; ++i) {
    const Lengths<double> links{random.uniform(0.3, 3), random.uniform(0.3, 3),
                                random.uniform(0.3, 3), random.uniform(0.3, 3)};
    auto expected = crank_ranges(links);
    const auto found = ranges_over_a_turn(as_mechanism(four_bar(links)));
    ASSERT_EQ(found.size(), expected.size());
    ++seen[found.size()];
    for (CrankRange& range : expected) {
      if (range.to - range.from > 6.283) continue;
      const double from = in_one_turn(range.from);
      range = {from, from + (range.to - range.from)};
    }
    std::ranges::sort(expected, {}, &CrankRange::from);
    for (std::size_t k = 0; k < found.size(); ++k) {
      const double tolerance = 1e-12 / (expected[k].to - expected[k].from);
      EXPECT_NEAR(found[k].from, expected[k].from, tolerance);
      EXPECT_NEAR(found[k].to, expected[k].to, tolerance);
    }
  }
  EXPECT_GT(seen[0], 5);
  EXPECT_GT(seen[1], 50);
  EXPECT_GT(seen[2], 20);
}

std::vector<double> drives(const AssemblyRanges& assembly_ranges, SpecialPositionKind kind) {
  std::vector<double> result;
  for (const SpecialPosition& point : assembly_ranges.points) {
    if (point.kind == kind) result.push_back(point.drive);
  }
  return result;
}

/// The greatest turn of a body between two of `steps` steps along the assembly ranges;
/// infinite where one does not close.
double greatest_step(const Mechanism<double>& mechanism, const AssemblyRanges& assembly_ranges,
                     int body, int steps) {
  FollowedMotion<1> motion(mechanism, assembly_ranges);
  Vec2d last{0, 0};
  double greatest = 0;
  for (int i = 0; i <= steps; ++i) {
    const double drive =
        assembly_ranges.start + (assembly_ranges.end - assembly_ranges.start) * i / steps;
    if (!motion.move_to(drive)) return std::numeric_limits<double>::infinity();
    const Vec2d direction = motion.bodies()[static_cast<std::size_t>(body)].direction;
    if (i > 0) greatest = std::max(greatest, std::sqrt(squared_norm(direction - last)));
    last = direction;
  }
  return greatest;
}

/// The parallelogram stays one: its coupler never turns, its rocker goes with the crank.
TEST(AssemblyRanges, AParallelogramStaysOne) {
  for (const double start : {0.0, 30 * kDegree, 180 * kDegree}) {
    for (const double sense : {1.0, -1.0}) {
      const bool is_above = std::sin(start + 0.1 * sense) > 0;
      const auto mechanism =
          as_mechanism(four_bar({1, 3, 1, 3}, is_above ? Assembly::open : Assembly::crossed));
      const AssemblyRanges assembly_ranges = follow(mechanism, start, start + sense * 4 * kPi);
      ASSERT_EQ(assembly_ranges.runs.size(), 1u);
      EXPECT_EQ(drives(assembly_ranges, SpecialPositionKind::change_point).size(),
                start == 30 * kDegree ? 4u : 5u);
      FollowedMotion<3> motion(mechanism, assembly_ranges);
      for (int step = 0; step <= 720; ++step) {
        const double crank = start + sense * 4 * kPi * step / 720;
        ASSERT_TRUE(motion.move_to(crank)) << crank;
        const auto& coupler = motion.bodies()[2];
        const auto& rocker = motion.bodies()[3];
        EXPECT_NEAR(coupler.direction.x, 1, 1e-13);
        EXPECT_NEAR(coupler.direction.y, 0, 1e-13);
        EXPECT_NEAR(coupler.turn[0], 0, 1e-11);
        EXPECT_NEAR(coupler.turn[1], 0, 1e-9);
        EXPECT_NEAR(rocker.direction.x, std::cos(crank), 1e-13);
        EXPECT_NEAR(rocker.turn[0], 1, 1e-11);
        EXPECT_NEAR(rocker.turn[1], 0, 1e-9);
        EXPECT_NEAR(rocker.turn[2], 0, 1e-5);
      }
    }
  }
}

/// The antiparallelogram's change points are its own: coupler and rocker pass through the line of
/// the frame, tan of the half angles having the fixed ratio (l₄ + l₁)/(l₄ − l₁).
TEST(AssemblyRanges, AnAntiparallelogramStaysOne) {
  const auto mechanism = as_mechanism(four_bar({1, 3, 1, 3}, Assembly::crossed));
  const AssemblyRanges assembly_ranges = follow(mechanism, 10 * kDegree, 370 * kDegree);
  const auto changes = drives(assembly_ranges, SpecialPositionKind::change_point);
  ASSERT_EQ(changes.size(), 2u);
  EXPECT_NEAR(changes[0], kPi, 1e-14);
  EXPECT_NEAR(changes[1], kTurn, 1e-14);
  FollowedMotion<1> motion(mechanism, assembly_ranges);
  for (int degree = 10; degree <= 370; ++degree) {
    ASSERT_TRUE(motion.move_to(degree * kDegree));
    const Vec2d rocker = motion.bodies()[3].direction;
    // tan(ψ/2) = −2 tan(θ/2) with ψ of D→C, cross-multiplied by both cosines.
    const double half = degree * kDegree / 2;
    const double expected = 2 * std::atan2(-2 * std::sin(half), std::cos(half));
    EXPECT_NEAR(rocker.x, std::cos(expected), 1e-12) << degree;
    EXPECT_NEAR(rocker.y, std::sin(expected), 1e-12) << degree;
  }
}

/// A kite whose crank is as long as the frame: B reaches D, where coupler and rocker are free to
/// turn together. Elsewhere the motion is smooth, and takes two turns of the crank.
TEST(AssemblyRanges, AKiteWithItsPinOnThePivotIsNotDetermined) {
  const auto mechanism = as_mechanism(four_bar({2, 3, 3, 2}));
  const AssemblyRanges assembly_ranges = follow(mechanism, -100.5 * kDegree, 619.5 * kDegree);
  EXPECT_EQ(drives(assembly_ranges, SpecialPositionKind::change_point).size(), 0u);
  const auto open = drives(assembly_ranges, SpecialPositionKind::undetermined);
  ASSERT_EQ(open.size(), 2u);
  EXPECT_NEAR(open[0], 0, 1e-15);
  EXPECT_NEAR(open[1], kTurn, 1e-15);
  EXPECT_LT(greatest_step(mechanism, assembly_ranges, 2, 720), 0.04);
  FollowedMotion<0> motion(mechanism, assembly_ranges);
  EXPECT_FALSE(motion.move_to(0));
  EXPECT_TRUE(std::isnan(motion.bodies()[3].direction.x));
  EXPECT_TRUE(motion.move_to(1e-3));
}

/// The other kite, crank = coupler: C reaches A with the four pivots in line, but the drive holds
/// every body.
TEST(AssemblyRanges, AKiteWithItsJointOnTheCrankPivotIsFollowed) {
  const auto mechanism = as_mechanism(four_bar({1, 1, 2, 2}));
  const AssemblyRanges assembly_ranges = follow(mechanism, 0, 4 * kPi);
  EXPECT_EQ(drives(assembly_ranges, SpecialPositionKind::change_point).size(), 5u);
  EXPECT_LT(greatest_step(mechanism, assembly_ranges, 3, 720), 0.04);
}

/// Coupler = crank on a centred slide: the pin goes as 2 r cos θ and the coupler mirrors the crank.
TEST(AssemblyRanges, ACentredSliderCrankOfEqualLinksPassesItsPivot) {
  Mechanism<double> mechanism;
  mechanism.drive = Crank<double>{{0, 0}, 1.5};
  mechanism.dyads.emplace_back(Rrp<double>{{1, {1.5, 0}}, 1.5, {}, Assembly::open});
  const AssemblyRanges assembly_ranges = follow(mechanism, 0, kTurn);
  const auto changes = drives(assembly_ranges, SpecialPositionKind::change_point);
  ASSERT_EQ(changes.size(), 2u);
  EXPECT_NEAR(changes[0], kRightAngle, 1e-14);
  FollowedMotion<2> motion(mechanism, assembly_ranges);
  for (int degree = 0; degree <= 360; ++degree) {
    const double crank = degree * kDegree;
    ASSERT_TRUE(motion.move_to(crank));
    EXPECT_NEAR(motion.bodies()[3].origin[0].x, 3 * std::cos(crank), 1e-12);
    EXPECT_NEAR(motion.bodies()[3].origin[1].x, -3 * std::sin(crank), 1e-10);
    EXPECT_NEAR(motion.bodies()[3].origin[2].x, -3 * std::cos(crank), 1e-8);
    EXPECT_NEAR(motion.bodies()[2].turn[0], -1, 1e-10);
  }
}

/// Crank = frame: the guide bar turns half as fast and is free when the block is on its pivot.
TEST(AssemblyRanges, AGuideBarOfEqualCrankAndFrameTurnsHalfAsFast) {
  int tested = 0;
  Mechanism<double> mechanism;
  mechanism.drive = Crank<double>{{0, 0}, 1};
  mechanism.dyads.emplace_back(Rpr<double>{{1, {1, 0}}, {0, {-1, 0}}, 0, Assembly::open});
  const AssemblyRanges assembly_ranges = follow(mechanism, 0, 4 * kPi);
  const auto open = drives(assembly_ranges, SpecialPositionKind::undetermined);
  ASSERT_EQ(open.size(), 2u);
  EXPECT_NEAR(open[0], kPi, 1e-14);
  EXPECT_NEAR(open[1], 3 * kPi, 1e-14);
  FollowedMotion<1> motion(mechanism, assembly_ranges);
  for (int degree = 1; degree <= 719; degree += 2) {
    if (degree % 360 == 180) continue;
    ++tested;
    ASSERT_TRUE(motion.move_to(degree * kDegree));
    EXPECT_NEAR(motion.bodies()[3].direction.x, std::cos(degree * kDegree / 2), 1e-12);
    EXPECT_NEAR(motion.bodies()[3].direction.y, std::sin(degree * kDegree / 2), 1e-12);
  }
  EXPECT_GE(tested, 320);
}

/// Two parallelograms in a row change at the same place, the second hanging on the first.
TEST(AssemblyRanges, ParallelogramsInARowChangeTogether) {
  Mechanism<double> mechanism = as_mechanism(four_bar({1, 3, 1, 3}));
  mechanism.dyads.emplace_back(Rrr<double>{{3, {1, 0}}, {0, {7, 0}}, 4, 1, Assembly::open});
  const AssemblyRanges assembly_ranges = follow(mechanism, 0.3, 0.3 + 4 * kPi);
  EXPECT_EQ(drives(assembly_ranges, SpecialPositionKind::change_point).size(), 8u);
  FollowedMotion<1> motion(mechanism, assembly_ranges);
  for (int i = 0; i <= 1000; ++i) {
    const double crank = 0.3 + 4 * kPi * i / 1000;
    ASSERT_TRUE(motion.move_to(crank));
    EXPECT_NEAR(motion.bodies()[5].direction.x, std::cos(crank), 1e-12);
    EXPECT_NEAR(motion.bodies()[5].direction.y, std::sin(crank), 1e-12);
    EXPECT_NEAR(motion.bodies()[4].turn[0], 0, 1e-9);
  }
  EXPECT_TRUE(motion.move_to(kPi));
  EXPECT_NEAR(motion.bodies()[5].turn[0], 1, 1e-8);
}

/// Rows that do not close are reported, and the motion goes on behind the gap as described.
TEST(AssemblyRanges, ATripleRockerLeavesGaps) {
  const Lengths<double> links{2, 2.5, 3, 4.5};
  const auto range = crank_ranges(links).at(0);
  const auto mechanism = as_mechanism(four_bar(links));
  for (const double sense : {1.0, -1.0}) {
    const AssemblyRanges assembly_ranges = follow(mechanism, 0.1, 0.1 + sense * kTurn);
    ASSERT_EQ(assembly_ranges.runs.size(), 2u);
    const auto ends = drives(assembly_ranges, SpecialPositionKind::dead_point);
    ASSERT_EQ(ends.size(), 2u);
    EXPECT_NEAR(ends[0], sense > 0 ? range.to : range.from, 1e-14);
    EXPECT_NEAR(ends[1], sense > 0 ? range.from + kTurn : range.to - kTurn, 1e-14);
    FollowedMotion<0> motion(mechanism, assembly_ranges);
    EXPECT_TRUE(motion.move_to(ends[0]));
    EXPECT_NEAR(motion.closures()[0].sine, 0, 1e-7);
    EXPECT_FALSE(motion.move_to((ends[0] + ends[1]) / 2));
    EXPECT_TRUE(motion.move_to(ends[1]));
    EXPECT_TRUE(motion.move_to(0.1 + sense * kTurn));
    EXPECT_GT(motion.closures()[0].sine, 0);
  }
}

/// A guide on the crank is parallel to one of the frame twice a turn; the pin goes through
/// infinity.
TEST(AssemblyRanges, GuidesInParallelEndARange) {
  Mechanism<double> mechanism;
  mechanism.drive = Crank<double>{{0, 0}, 1};
  mechanism.dyads.emplace_back(Prp<double>{{1, {1, 0}, {1, 0}, 0}, {0, {0, 2}, {1, 0}, 0}});
  const AssemblyRanges assembly_ranges = follow(mechanism, 0.5, 0.5 + kTurn);
  ASSERT_EQ(assembly_ranges.runs.size(), 3u);
  const auto ends = drives(assembly_ranges, SpecialPositionKind::parallel_guides);
  ASSERT_EQ(ends.size(), 4u);
  EXPECT_NEAR(ends[0], kPi, 1e-11);
  EXPECT_NEAR(ends[3], kTurn, 1e-11);
}

/// Random chains of three dyads: the runs are where all dyads close, tried at random places.
TEST(AssemblyRanges, RunsAreWhereAChainCloses) {
  test::ChainMaker random(23);
  int gaps = 0;
  for (int drive = 0; drive < 3; ++drive) {
    for (int types = 0; types < 125; ++types) {
      const auto mechanism = random.make(drive, {types / 25, types / 5 % 5, types % 5});
      const double start = random.uniform(-1, 1);
      const AssemblyRanges assembly_ranges = follow(mechanism, start, start + kTurn);
      MechanismMotion<0> motion(mechanism);
      for (int i = 0; i < 200; ++i) {
        const double at = random.uniform(start, start + kTurn);
        const bool closes = motion.move_to(at);
        EXPECT_EQ(assembly_ranges.range_at(at) != nullptr, closes)
            << "drive " << drive << " types " << types << " at " << at;
        gaps += closes ? 0 : 1;
      }
      for (const SpecialPosition& point : assembly_ranges.points) {
        EXPECT_TRUE(motion.move_to(point.drive));
        const auto& closure = motion.closures()[static_cast<std::size_t>(point.dyad)];
        EXPECT_LT(std::abs(closure.sine), 1e-5);
      }
    }
  }
  EXPECT_GT(gaps, 1000);
}

/// Whoever says stop is asked at every place and obeyed at once.
TEST(AssemblyRanges, EndsWhenItIsStopped) {
  const auto mechanism = as_mechanism(four_bar({1, 3, 3, 3}));
  int asked = 0;
  const AssemblyRanges whole = follow(mechanism, 0, kTurn, [&] {
    ++asked;
    return false;
  });
  ASSERT_EQ(whole.runs.size(), 1u);
  EXPECT_NEAR(whole.runs.front().to, kTurn, 1e-12);
  EXPECT_GE(asked, 720);

  int places = 0;
  follow(mechanism, 0, kTurn, [&] { return ++places > 100; });
  EXPECT_LT(places, 110);
}

}  // namespace
}  // namespace cognate::assembly_ranges_test
