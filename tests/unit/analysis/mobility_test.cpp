/// What link lengths settle, held against published linkages, the position kernel and 113 bits.
#include "analysis/linkage/mobility.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <random>

#include "analysis/linkage/motion.hpp"
#include "analysis/numbers/constants.hpp"

namespace cognate::mobility_test {

void PrintTo(const Lengths<double>& links, std::ostream* out) {
  *out << std::hexfloat << "{" << links.crank << ", " << links.coupler << ", " << links.rocker
       << ", " << links.frame << "}";
}

namespace {

using Quad = boost::multiprecision::cpp_bin_float_quad;
constexpr double pi = kPi;
constexpr double degree = pi / 180;

FourBar linkage_of(const Lengths<double>& links, Assembly assembly = Assembly::open) {
  return {{0, 0}, {links.frame, 0}, links.crank, links.coupler, links.rocker, assembly, {}};
}

Lengths<double> scaled(const Lengths<double>& l, double k) {
  return {k * l.crank, k * l.coupler, k * l.rocker, k * l.frame};
}

Lengths<double> random_lengths(std::mt19937_64& random) {
  std::uniform_real_distribution<double> length(0.1, 1.0);
  return {length(random), length(random), length(random), length(random)};
}

TEST(Mobility, HasThePublishedClasses) {
  // Li & Xu 2011, example 3-1; the second set of lengths 10, 30, 35, 50 with each link as the
  // shortest.
  EXPECT_EQ(mobility_class(Lengths<double>{100, 150, 170, 110}), MobilityClass::triple_rocker);
  EXPECT_EQ(mobility_class(Lengths<double>{10, 50, 35, 30}), MobilityClass::crank_rocker);
  EXPECT_EQ(mobility_class(Lengths<double>{30, 50, 35, 10}), MobilityClass::double_crank);
  EXPECT_EQ(mobility_class(Lengths<double>{30, 10, 35, 50}), MobilityClass::double_rocker);
  EXPECT_EQ(mobility_class(Lengths<double>{30, 50, 10, 35}), MobilityClass::rocker_crank);
}

TEST(Mobility, CrankTurnsFullyExactlyWhereGrashofSays) {
  std::mt19937_64 random(11);
  int turning = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto links = random_lengths(random);
    const auto type = mobility_class(links);
    const bool turns = type == MobilityClass::crank_rocker || type == MobilityClass::double_crank;
    EXPECT_EQ(crank_rotates(links), turns) << ::testing::PrintToString(links);
    turning += turns;
  }
  EXPECT_GT(turning, 1000);
}

TEST(Mobility, ChangePointsAreRecognisedThroughRounding) {
  // Sums that are equal on paper and not in binary: 0.1 + 0.7 = 0.3 + 0.5 = 0.8.
  const Lengths<double> decimal{0.1, 0.3, 0.5, 0.7};
  using enum MobilityClass;
  const std::pair<Lengths<double>, MobilityClass> cases[] = {{decimal, crank_rocker},
                                                             {{0.1, 0.7, 0.3, 0.5}, crank_rocker},
                                                             {{0.1, 0.7, 0.1, 0.7}, double_crank},
                                                             {{0.7, 0.1, 0.7, 0.1}, double_crank},
                                                             {{0.3, 0.7, 0.7, 0.3}, double_crank},
                                                             {{0.7, 0.3, 0.3, 0.7}, rocker_crank},
                                                             {{0.3, 0.3, 0.7, 0.7}, crank_rocker},
                                                             {{0.7, 0.7, 0.3, 0.3}, double_crank},
                                                             {{0.7, 0.7, 0.7, 0.7}, double_crank}};
  for (const double scale : {1e-100, 1.0, 3.0, 1e100}) {
    for (const auto& [links, expected] : cases) {
      const bool turns = expected == crank_rocker || expected == double_crank;
      EXPECT_TRUE(is_change_point(scaled(links, scale)));
      EXPECT_EQ(crank_rotates(scaled(links, scale)), turns) << ::testing::PrintToString(links);
      EXPECT_EQ(mobility_class(scaled(links, scale)), expected) << ::testing::PrintToString(links);
    }
  }
  EXPECT_FALSE(is_change_point(Lengths<double>{0.1, 0.3, 0.5, 0.7 + 1e-14}));
  EXPECT_FALSE(crank_rotates(Lengths<double>{0.1, 0.3, 0.5, 0.7 + 1e-14}));
  EXPECT_TRUE(crank_rotates(Lengths<double>{0.1, 0.3, 0.5, 0.7 - 1e-14}));
}

/// Independent of sums by pairs: in a Grashof linkage, ties included, the joints at the ends of a
/// shortest link turn fully, and no others. Exact, as lengths are small integers.
MobilityClass class_by_joints(const std::array<int, 4>& l) {
  const int shortest = std::ranges::min(l), longest = std::ranges::max(l);
  if (2 * (shortest + longest) > l[0] + l[1] + l[2] + l[3]) return MobilityClass::triple_rocker;
  const bool crank = l[0] == shortest || l[3] == shortest;
  const bool rocker = l[2] == shortest || l[3] == shortest;
  if (crank && rocker) return MobilityClass::double_crank;
  if (crank) return MobilityClass::crank_rocker;
  return rocker ? MobilityClass::rocker_crank : MobilityClass::double_rocker;
}

TEST(Mobility, ClassesOfAllSmallIntegersIncludingTies) {
  int checked = 0, ties = 0;
  std::array<int, 4> l{};
  for (int code = 0; code < 10000; ++code) {
    int rest = code;
    for (int& length : l) {
      length = 1 + rest % 10;
      rest /= 10;
    }
    const Lengths<double> links{double(l[0]), double(l[1]), double(l[2]), double(l[3])};
    if (!can_assemble(links)) continue;
    const MobilityClass expected = class_by_joints(l);
    const int excess =
        2 * (std::ranges::min(l) + std::ranges::max(l)) - (l[0] + l[1] + l[2] + l[3]);
    ++checked;
    ties += excess == 0;
    ASSERT_EQ(mobility_class(links), expected) << ::testing::PrintToString(links);
    ASSERT_EQ(mobility_class(scaled(links, 0.1)), expected) << ::testing::PrintToString(links);
    ASSERT_EQ(is_change_point(scaled(links, 0.1)), excess == 0) << ::testing::PrintToString(links);
    const bool crank =
        expected == MobilityClass::crank_rocker || expected == MobilityClass::double_crank;
    const bool rocker =
        expected == MobilityClass::rocker_crank || expected == MobilityClass::double_crank;
    ASSERT_EQ(crank_rotates(links), crank) << ::testing::PrintToString(links);
    ASSERT_EQ(rocker_rotates(links), rocker) << ::testing::PrintToString(links);
  }
  EXPECT_GT(checked, 8000);
  EXPECT_GT(ties, 500);
}

TEST(Mobility, RangesOfTheCrankAreWhereTheKernelCloses) {
  int tested = 0;
  std::mt19937_64 random(12);
  std::array<int, 3> count{};
  for (int i = 0; i < 3000; ++i) {
    const auto links = random_lengths(random);
    const auto ranges = crank_ranges(links);
    EXPECT_EQ(ranges.empty(), !can_assemble(links));
    ++count[ranges.size()];
    const Motion motion(linkage_of(links));
    const auto is_inside = [&](double angle) {
      return std::ranges::any_of(ranges, [&](const CrankRange& range) {
        const double turn =
            angle - range.from - 2 * pi * std::floor((angle - range.from) / (2 * pi));
        return turn <= range.to - range.from;
      });
    };
    for (int k = 0; k < 50; ++k) {
      const double angle = 2 * pi * (k + 0.37) / 50;
      EXPECT_EQ(motion.at(angle).has_value(), is_inside(angle))
          << ::testing::PrintToString(links) << " at " << angle;
    }
    for (const auto& [from, to] : ranges) {
      if (to - from > 6.28 || to - from < 1e-3) continue;
      ++tested;
      EXPECT_TRUE(motion.at(from + 1e-9) && motion.at(to - 1e-9))
          << ::testing::PrintToString(links);
      EXPECT_FALSE(motion.at(from - 1e-9) || motion.at(to + 1e-9))
          << ::testing::PrintToString(links);
    }
  }
  EXPECT_GT(std::ranges::min(count), 50);
  EXPECT_GE(tested, 2500);
}

TEST(Mobility, TransmissionAnglesBoundTheSampledOnes) {
  int tested = 0;
  std::mt19937_64 random(13);
  for (int i = 0; i < 40; ++i) {
    const auto links = random_lengths(random);
    if (!can_assemble(links)) continue;
    ++tested;
    const auto [min, max, acute] = transmission_angles(links);
    const Motion motion(linkage_of(links));
    double least = pi, greatest = 0;
    constexpr int samples = 20000;
    for (int k = 0; k < samples; ++k) {
      const auto pose = motion.at(2 * pi * k / samples);
      if (!pose) continue;
      least = std::min(least, pose->transmission_angle);
      greatest = std::max(greatest, pose->transmission_angle);
    }
    // From inside, and within a sample's step: of square-root kind where μ reaches 0 or π.
    EXPECT_LE(min, least + 1e-12) << ::testing::PrintToString(links);
    EXPECT_GE(max, greatest - 1e-12) << ::testing::PrintToString(links);
    EXPECT_NEAR(min, least, 0.08) << ::testing::PrintToString(links);
    EXPECT_NEAR(max, greatest, 0.08) << ::testing::PrintToString(links);
    if (crank_rotates(links)) {
      EXPECT_NEAR(min, least, 1e-4) << ::testing::PrintToString(links);
      EXPECT_NEAR(max, greatest, 1e-4) << ::testing::PrintToString(links);
    }
    EXPECT_NEAR(acute, std::min(min, pi - max), 1e-14);
  }
  EXPECT_GE(tested, 35);
}

TEST(Mobility, TransmissionAnglesOverARangeBoundTheSampledOnes) {
  std::mt19937_64 random(17);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  int checked = 0, inside = 0;
  for (int i = 0; i < 600; ++i) {
    const auto links = random_lengths(random);
    const auto ranges = crank_ranges(links);
    if (ranges.empty()) continue;
    const double span = ranges[0].to - ranges[0].from;
    // Off the dead points, so that samples come near the extremes.
    const double first = 0.05 + 0.4 * unit(random), last = 0.55 + 0.4 * unit(random);
    const CrankRange range{ranges[0].from + first * span, ranges[0].from + last * span};
    const auto [min, max, acute] = transmission_angles(links, range);
    const Motion motion(linkage_of(links));
    double least = pi, greatest = 0;
    for (int k = 0; k <= 2000; ++k) {
      const double angle = range.from + (range.to - range.from) * k / 2000;
      const double sample = motion.at(angle)->transmission_angle;
      least = std::min(least, sample);
      greatest = std::max(greatest, sample);
    }
    ++checked;
    const double first_end = motion.at(range.from)->transmission_angle,
                 last_end = motion.at(range.to)->transmission_angle;
    inside += least < std::min(first_end, last_end) - 1e-3 ||
              greatest > std::max(first_end, last_end) + 1e-3;
    EXPECT_NEAR(min, least, 1e-4) << ::testing::PrintToString(links);
    EXPECT_NEAR(max, greatest, 1e-4) << ::testing::PrintToString(links);
    EXPECT_LE(min, least + 1e-12) << ::testing::PrintToString(links);
    EXPECT_GE(max, greatest - 1e-12) << ::testing::PrintToString(links);
    EXPECT_NEAR(acute, std::min(min, pi - max), 1e-14);
  }
  EXPECT_GT(std::min(checked, inside), 100);
}

TEST(Mobility, TransmissionAnglesKeepTheirDigitsAtAnyScale) {
  int tested = 0;
  // Nearly stretched and nearly folded, against acos in 113 bits.
  std::mt19937_64 random(14);
  std::uniform_real_distribution<double> unit(0.2, 1.0);
  for (int i = 0; i < 2000; ++i) {
    const double gap = std::pow(10.0, -1 - i % 13);
    const double l1 = 0.1 * unit(random), l2 = unit(random), l3 = 1.5 + unit(random);
    const Lengths<double> links{l1, l2, l3, (l3 - l2) * (1 + gap) + l1};
    if (!crank_rotates(links)) continue;
    ++tested;
    const Quad a = links.coupler, b = links.rocker, d = Quad(links.frame) - Quad(links.crank);
    const Quad expected = acos((a * a + b * b - d * d) / (2 * a * b));
    for (const double scale : {1e-100, 1.0, 1e100}) {
      // The lengths times 10^±100 are rounded, by which μ² moves by ε relative to the gap.
      const double tolerance = scale == 1.0 ? 1e-15 : 1e-15 / gap;
      const double min = transmission_angles(scaled(links, scale)).min;
      EXPECT_NEAR(min / double(expected), 1, tolerance) << ::testing::PrintToString(links);
    }
  }
  EXPECT_GE(tested, 1800);
}

TEST(Mobility, HasThePublishedTransmissionAndDeadCentreAngles) {
  // Li & Xu 2011, example 7-1, recomputed with 30 digits (largest transmission angle 135°).
  const Lengths<double> links{1, 4.128654158009783, 2.3224617124121694, 5};
  const auto angles = transmission_angles(links);
  EXPECT_NEAR(angles.min / degree, 70.37918100668526, 1e-7);
  EXPECT_NEAR(angles.max / degree, 135.0, 1e-7);
  EXPECT_NEAR(angles.acute_min / degree, 45.0, 1e-7);
  const auto outer = outer_limit(links);
  ASSERT_TRUE(outer);
  EXPECT_NEAR(outer->crank_angle / degree, 26.47200251587829, 1e-7);
  EXPECT_NEAR(outer->rocker_angle / degree, 100.14488276087012, 1e-7);
}

TEST(Mobility, HasThePublishedTimeRatioAndSwing) {
  // Li & Xu 2011, example 3-8: K = 1.25 and a swing of 34° prescribed, four ways to the rest.
  const Lengths<double> designs[] = {
      {77.29265548020777, 215.08512711099073, 290, 277.28748496880445},
      {77.0, 218.43520498001126, 290, 276.8037081761766},
      {77.30001875403204, 215, 290, 277.2996696569583},
      {77.1188168514126, 217.08285220138112, 290, 277.0}};
  for (const auto& links : designs) {
    const auto ratio = time_ratio(links);
    const auto outer = outer_limit(links), inner = inner_limit(links);
    ASSERT_TRUE(ratio && outer && inner);
    EXPECT_NEAR(*ratio, 1.25, 1e-12);
    EXPECT_NEAR(std::abs(outer->rocker_angle - inner->rocker_angle) / degree, 34, 1e-11);
  }
}

/// The turn from `from` to `angle`, in (−π, π].
double turn(double from, double angle) {
  return std::remainder(angle - from, 2 * pi);
}

TEST(Mobility, LimitsAreTheExtremesOfTheSampledRocker) {
  std::mt19937_64 random(15);
  int checked = 0;
  for (int i = 0; i < 2000 && checked < 60; ++i) {
    const auto links = random_lengths(random);
    if (mobility_class(links) != MobilityClass::crank_rocker) continue;
    ++checked;
    for (const Assembly assembly : {Assembly::open, Assembly::crossed}) {
      const auto outer = outer_limit(links), inner = inner_limit(links);
      ASSERT_TRUE(outer && inner) << ::testing::PrintToString(links);
      const double mirror = sign(assembly);
      const Motion motion(linkage_of(links, assembly));
      // At its limits the rocker stands where it should, …
      EXPECT_NEAR(
          turn(motion.at(mirror * outer->crank_angle)->rocker_angle, mirror * outer->rocker_angle),
          0, 1e-9);
      EXPECT_NEAR(
          turn(motion.at(mirror * inner->crank_angle)->rocker_angle, mirror * inner->rocker_angle),
          0, 1e-9);
      // … and goes no further: every sample lies on the inner side of both.
      const double swing = turn(inner->rocker_angle, outer->rocker_angle);
      double least = 1, greatest = -1;
      for (int k = 0; k < 4000; ++k) {
        const double angle = motion.at(2 * pi * k / 4000)->rocker_angle;
        const double share = turn(mirror * inner->rocker_angle, angle) / (mirror * swing);
        least = std::min(least, share);
        greatest = std::max(greatest, share);
      }
      EXPECT_NEAR(least, 0, 1e-4) << ::testing::PrintToString(links);
      EXPECT_NEAR(greatest, 1, 1e-4) << ::testing::PrintToString(links);
      EXPECT_GE(least, -1e-9);
      EXPECT_LE(greatest, 1 + 1e-9);
    }
  }
  EXPECT_EQ(checked, 60);
}

TEST(Mobility, TimeRatioIsThatOfTheSampledSwing) {
  std::mt19937_64 random(16);
  int checked = 0;
  for (int i = 0; i < 2000 && checked < 60; ++i) {
    const auto links = random_lengths(random);
    if (mobility_class(links) != MobilityClass::crank_rocker) {
      EXPECT_FALSE(time_ratio(links)) << ::testing::PrintToString(links);
      continue;
    }
    ++checked;
    const Motion motion(linkage_of(links));
    // Crank steps in which the rocker advances and in which it returns.
    constexpr int samples = 20000;
    int advance = 0;
    double previous = motion.at(0)->rocker_angle;
    for (int k = 1; k <= samples; ++k) {
      const double angle = motion.at(2 * pi * k / samples)->rocker_angle;
      advance += turn(previous, angle) > 0;
      previous = angle;
    }
    const double longer = std::max(advance, samples - advance);
    const double sampled = longer / (samples - longer);
    EXPECT_NEAR(*time_ratio(links) / sampled, 1, 2e-3) << ::testing::PrintToString(links);
  }
  EXPECT_EQ(checked, 60);
}

/// A kite whose crank is as long as its coupler swings from one change point to another: its crank
/// turns by nothing from one limit to the other.
TEST(Mobility, TimeRatioOfChangePointsIsNeverInfinite) {
  std::mt19937_64 random(12);
  std::uniform_real_distribution<double> length(0.2, 3), rounding(-4, 4);
  for (int i = 0; i < 2000; ++i) {
    const double a = length(random), b = length(random);
    const auto near = [&](double x) { return x * (1 + 0x1p-53 * std::round(rounding(random))); };
    for (const Lengths<double>& links : {Lengths<double>{near(a), near(a), near(b), near(b)},
                                         Lengths<double>{near(a), near(b), near(b), near(a)},
                                         Lengths<double>{near(a), near(b), near(a), near(b)}}) {
      EXPECT_TRUE(std::isfinite(time_ratio(links).value_or(1))) << ::testing::PrintToString(links);
    }
  }
}

TEST(Mobility, WhatCannotBeAssembledIsSaid) {
  const Lengths<double> links{1, 1, 1, 3.5};
  EXPECT_FALSE(can_assemble(links));
  EXPECT_FALSE(crank_rotates(links));
  EXPECT_TRUE(crank_ranges(links).empty());
  EXPECT_TRUE(std::isnan(transmission_angles(links).min));
  EXPECT_FALSE(outer_limit(links) || inner_limit(links) || time_ratio(links));
  EXPECT_TRUE(can_assemble(Lengths<double>{1, 1, 1, 3}));
  // C on A: the coupler covers the crank, which may point anywhere.
  EXPECT_FALSE(inner_limit(Lengths<double>{1, 1, 2, 2}));
}

}  // namespace
}  // namespace cognate::mobility_test
