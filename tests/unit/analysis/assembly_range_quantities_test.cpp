/// Limit positions, time ratio, transmission angles and faults of assembly, against closed forms.
#include <gtest/gtest.h>

#include <cmath>

#include "analysis/linkage/four_bar.hpp"
#include "analysis/linkage/mobility.hpp"
#include "analysis/mechanism/assembly_fault.hpp"
#include "analysis/mechanism/output_limits.hpp"
#include "analysis/mechanism/transmission_extremes.hpp"
#include "analysis/numbers/angle.hpp"
#include "analysis/numbers/constants.hpp"
#include "tests/support/random_chains.hpp"

namespace cognate::assembly_range_quantities_test {
namespace {

FourBar four_bar(const Lengths<double>& links, Assembly assembly = Assembly::open) {
  return {{0, 0}, {links.frame, 0}, links.crank, links.coupler, links.rocker, assembly, {}};
}

Lengths<double> random_links(test::ChainMaker& random) {
  return {random.uniform(0.3, 3), random.uniform(0.3, 3), random.uniform(0.3, 3),
          random.uniform(0.3, 3)};
}

TEST(AssemblyRangeQuantities, LimitsAndTimeRatioOfCrankRockersAreTheClosedForm) {
  test::ChainMaker random(5);
  int rockers = 0;
  for (int i = 0; i < 400; ++i) {
    const Lengths<double> links = random_links(random);
    if (mobility_class(links) != MobilityClass::crank_rocker || !can_assemble(links)) continue;
    ++rockers;
    const auto mechanism = as_mechanism(four_bar(links));
    const double start = random.uniform(-7, 7), sense = i % 2 == 0 ? 1 : -1;
    const AssemblyRanges assembly_ranges = follow(mechanism, start, start + sense * kTurn);
    const auto output = output_range(mechanism, assembly_ranges, travels(mechanism)[3]);
    ASSERT_TRUE(output);
    ASSERT_EQ(output->limits.size(), 2u);
    const auto outer = outer_limit(links), inner = inner_limit(links);
    for (const auto& expected : {*outer, *inner}) {
      const auto off = [&](const OutputValue& limit) {
        return std::abs(std::remainder(limit.drive - expected.crank_angle, kTurn));
      };
      const auto& limits = output->limits;
      const OutputValue& found = off(limits[0]) < off(limits[1]) ? limits[0] : limits[1];
      EXPECT_LT(off(found), 1e-12);
      EXPECT_NEAR(std::remainder(found.value - expected.rocker_angle, kTurn), 0, 1e-12);
    }
    const double swing = std::abs(std::remainder(outer->rocker_angle - inner->rocker_angle, kTurn));
    EXPECT_NEAR(output->stroke(), swing, 1e-12);
    const auto ratio = time_ratio(mechanism, assembly_ranges, *output);
    ASSERT_TRUE(ratio);
    EXPECT_NEAR(*ratio, *time_ratio(links), 1e-11 * *ratio);
  }
  EXPECT_GT(rockers, 30);
}

TEST(AssemblyRangeQuantities, TransmissionAnglesAreTheClosedForm) {
  int tested = 0;
  test::ChainMaker random(6);
  for (int i = 0; i < 200; ++i) {
    const Lengths<double> links = random_links(random);
    if (!can_assemble(links)) continue;
    ++tested;
    const auto mechanism = as_mechanism(four_bar(links));
    const auto found = transmission_extremes(mechanism, follow(mechanism, 0.3, 0.3 + kTurn), 0);
    const auto expected = transmission_angles(links);
    ASSERT_TRUE(found);
    // At a dead point the angle goes with the root of what rounding leaves of the discriminant.
    EXPECT_NEAR(found->least.angle, expected.min, expected.min == 0 ? 1e-6 : 1e-12);
    EXPECT_NEAR(found->greatest.angle, expected.max, expected.max > 3.14159265 ? 1e-6 : 1e-12);
    EXPECT_NEAR(found->acute_least(), expected.acute_min, 1e-6);
  }
  EXPECT_GE(tested, 170);
}

/// An offset slider-crank: limits at √((l₂ ± l₁)² − e²), pressure angle asin((l₁ + |e|)/l₂).
TEST(AssemblyRangeQuantities, AnOffsetSliderCrank) {
  const double r = 2, l = 5, e = 0.75;
  Mechanism<double> mechanism;
  mechanism.drive = Crank<double>{{1, 1}, r};
  const Guide<double> guide{0, {1, 1}, {0.6, 0.8}, e};
  mechanism.dyads.emplace_back(Rrp<double>{{1, {r, 0}}, l, guide, Assembly::open});
  const double outer = std::sqrt((l + r) * (l + r) - e * e);
  const double inner = std::sqrt((l - r) * (l - r) - e * e);
  const double advance =
      kPi + std::asin(e / (l + r)) - std::asin(e / (l - r));  // from inner to outer or back
  const double longer = std::max(advance, kTurn - advance);
  for (const double start : {0.0, 2.2}) {
    const AssemblyRanges assembly_ranges = follow(mechanism, start, start + kTurn);
    const auto slider = output_range(mechanism, assembly_ranges, travels(mechanism)[3]);
    const auto point = output_range(mechanism, assembly_ranges, {3, {0, 0}}, guide.direction);
    ASSERT_TRUE(slider && point);
    EXPECT_EQ(slider->limits.size(), 2u);
    EXPECT_NEAR(slider->greatest.value, outer, 1e-14);
    EXPECT_NEAR(slider->least.value, inner, 1e-14);
    EXPECT_NEAR(point->stroke(), outer - inner, 1e-14);
    EXPECT_NEAR(*time_ratio(mechanism, assembly_ranges, *slider), longer / (kTurn - longer), 1e-13);
    const auto angles = transmission_extremes(mechanism, assembly_ranges, 0);
    EXPECT_NEAR(angles->greatest_pressure(), std::asin((r + e) / l), 1e-14);
  }
}

/// A whole turn that starts on a limit position reaches it twice and counts it once.
TEST(AssemblyRangeQuantities, ATurnFromALimitCountsItOnce) {
  Mechanism<double> mechanism;
  mechanism.drive = Crank<double>{{0, 0}, 1};
  mechanism.dyads.emplace_back(Rrp<double>{{1, {1, 0}}, 3, {}, Assembly::open});
  for (const double start : {0.0, kPi}) {
    for (const double sense : {1.0, -1.0}) {
      const AssemblyRanges assembly_ranges = follow(mechanism, start, start + sense * kTurn);
      const auto output = output_range(mechanism, assembly_ranges, travels(mechanism)[3]);
      ASSERT_EQ(output->limits.size(), 2u);
      EXPECT_NEAR(output->limits[0].drive, start, 1e-12);
      EXPECT_NEAR(output->limits[1].drive, start + sense * kPi, 1e-12);
      EXPECT_NEAR(*time_ratio(mechanism, assembly_ranges, *output), 1, 1e-12);
    }
  }
}

/// An output that stands has no limits, for all the rounding in its derivative.
TEST(AssemblyRangeQuantities, ABodyThatOnlyTranslatesHasNoLimitsOfItsAngle) {
  const auto mechanism = as_mechanism(four_bar({1, 3, 1, 3}));
  const AssemblyRanges assembly_ranges = follow(mechanism, 0.1, 0.1 + kTurn);
  const auto coupler = output_range(mechanism, assembly_ranges, travels(mechanism)[2]);
  EXPECT_TRUE(coupler->limits.empty());
  EXPECT_NEAR(coupler->stroke(), 0, 1e-12);
  const auto rocker = output_range(mechanism, assembly_ranges, travels(mechanism)[3]);
  EXPECT_NEAR(rocker->stroke(), kTurn, 1e-12);
  EXPECT_FALSE(time_ratio(mechanism, assembly_ranges, *rocker));
}

TEST(AssemblyRangeQuantities, FaultsOfAssemblyAreNamedInNumbers) {
  Mechanism<double> mechanism = as_mechanism({{0, 0}, {150, 0}, 20, 50, 70, Assembly::open, {}});
  const auto far = assembly_fault(mechanism, 0);
  ASSERT_TRUE(far);
  EXPECT_EQ(far->kind, AssemblyFaultKind::too_far_apart);
  EXPECT_EQ(far->dyad, 0);
  EXPECT_DOUBLE_EQ(far->distance, 130);
  EXPECT_EQ(far->first, 50);
  EXPECT_EQ(far->second, 70);

  const auto near = assembly_fault(as_mechanism({{0, 0}, {50, 0}, 20, 50, 10, {}, {}}), 0);
  ASSERT_TRUE(near);
  EXPECT_EQ(near->kind, AssemblyFaultKind::too_near);
  EXPECT_DOUBLE_EQ(near->distance, 30);
  EXPECT_EQ(near->first, 50);
  EXPECT_EQ(near->second, 10);

  Mechanism<double> chain = as_mechanism({{0, 0}, {60, 0}, 20, 50, 50, Assembly::open, {}});
  chain.dyads.emplace_back(Rrp<double>{{1, {20, 0}}, 8, {0, {0, 25}, {1, 0}, 5}, {}});
  const auto slider = assembly_fault(chain, 0);
  ASSERT_TRUE(slider);
  EXPECT_EQ(slider->dyad, 1);
  EXPECT_EQ(slider->kind, AssemblyFaultKind::guide_too_far);
  EXPECT_DOUBLE_EQ(slider->distance, 30);
  EXPECT_EQ(slider->first, 8);

  chain.dyads[1] = Rpr<double>{{1, {20, 0}}, {0, {23, 0}}, -4, {}};
  EXPECT_EQ(assembly_fault(chain, 0)->kind, AssemblyFaultKind::inside_offset);
  EXPECT_DOUBLE_EQ(assembly_fault(chain, 0)->distance, 3);
  chain.dyads[1] = Prp<double>{{1, {}, {1, 0}, 0}, {0, {}, {-1, 0}, 0}};
  EXPECT_EQ(assembly_fault(chain, 0)->kind, AssemblyFaultKind::parallel_guides);
  EXPECT_FALSE(assembly_fault(chain, 1));
}

}  // namespace
}  // namespace cognate::assembly_range_quantities_test
