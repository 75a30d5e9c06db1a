/// Slider-cranks, guide-bars and the shaper from the time ratio.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "analysis/linkage/guide_bar_mobility.hpp"
#include "analysis/numbers/constants.hpp"
#include "synthesis/exact/quick_return/guide.hpp"
#include "synthesis/exact/quick_return/shaper.hpp"
#include "synthesis/exact/quick_return/slider.hpp"

namespace cognate::synthesis::quick_return_slider_test {
namespace {

constexpr double pi = kPi;

[[nodiscard]] bool has(const SliderSolutions& found, const SliderCrank& planted) {
  return std::ranges::any_of(found.designs, [&](const QuickReturnSlider& design) {
    const SliderCrank& own = design.mechanism;
    const double off =
        std::max({std::abs(own.crank - planted.crank), std::abs(own.coupler - planted.coupler),
                  std::abs(own.offset - planted.offset)});
    return own.assembly == planted.assembly && off <= 1e-14 * design.condition * planted.coupler;
  });
}

TEST(QuickReturnSlider, RecoversPlantedMechanisms) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> share(0.05, 0.95), exponent(-12, 12);
  int offset = 0, crank = 0, coupler = 0;
  constexpr int planted = 3000;
  for (int i = 0; i < planted; ++i) {
    const double unit = std::pow(10, exponent(random));
    SliderCrank mechanism;
    mechanism.coupler = unit;
    mechanism.crank = share(random) * unit;
    mechanism.offset = (unit - mechanism.crank) * share(random) * (i % 2 == 0 ? 1 : -1);
    mechanism.assembly = i % 3 == 0 ? Assembly::crossed : Assembly::open;
    const SliderTask task{*time_ratio(mechanism), *stroke(mechanism)};
    offset += has(sliders_with_offset(task, mechanism.offset), mechanism);
    crank += has(sliders_with_crank(task, mechanism.crank), mechanism);
    coupler += has(sliders_with_coupler(task, mechanism.coupler), mechanism);
  }
  EXPECT_EQ(offset, planted);
  EXPECT_EQ(crank, planted);
  EXPECT_EQ(coupler, planted);
}

TEST(QuickReturnSlider, KeepsToItsLimits) {
  const SliderTask task{1.4, 100};
  const SliderLimits limits = slider_limits(task);
  const auto count = [](const SliderSolutions& found) { return found.designs.size(); };
  EXPECT_EQ(count(sliders_with_offset(task, limits.offset.max * (1 - 1e-9))), 2U);
  EXPECT_EQ(count(sliders_with_offset(task, limits.offset.max * (1 + 1e-9))), 0U);
  EXPECT_EQ(count(sliders_with_crank(task, limits.crank.min * (1 + 1e-9))), 4U);
  EXPECT_EQ(count(sliders_with_crank(task, limits.crank.min * (1 - 1e-9))), 0U);
  EXPECT_EQ(count(sliders_with_crank(task, limits.crank.max * (1 + 1e-9))), 0U);
  EXPECT_EQ(count(sliders_with_coupler(task, limits.coupler.max * (1 - 1e-9))), 4U);
  EXPECT_EQ(count(sliders_with_coupler(task, limits.coupler.max * (1 + 1e-9))), 0U);
  EXPECT_EQ(count(sliders_with_offset({3.01, 100}, 1e-3)), 0U);  // K < 3
  EXPECT_EQ(count(best_sliders({3, 100})), 0U);
}

TEST(QuickReturnSlider, Degeneracies) {
  EXPECT_EQ(sliders_with_offset({1, 100}, 0).degeneracy, SliderDegeneracy::any_coupler);
  EXPECT_EQ(sliders_with_offset({1, 100}, 3).degeneracy, SliderDegeneracy::no_quick);
  EXPECT_EQ(sliders_with_offset({1.2, 100}, 0).degeneracy, SliderDegeneracy::no_offset);
  EXPECT_EQ(sliders_with_crank({1, 100}, 50).degeneracy, SliderDegeneracy::any_coupler);
  EXPECT_EQ(best_sliders({1, 100}).degeneracy, SliderDegeneracy::any_coupler);
  const auto centred = sliders_with_coupler({1, 100}, 180);
  ASSERT_EQ(centred.designs.size(), 2U);
  EXPECT_EQ(centred.designs[0].mechanism.crank, 50);
  EXPECT_EQ(centred.designs[0].mechanism.offset, 0);
}

TEST(QuickReturnSlider, LeansLeast) {
  for (const double ratio : {1.001, 1.1, 1.4, 2.0, 2.9}) {
    const SliderTask task{ratio, 100};
    const auto best = best_sliders(task);
    ASSERT_EQ(best.designs.size(), 4U) << ratio;
    const double least = best.designs[0].pressure;
    const double most = slider_limits(task).offset.max;
    double sampled = pi / 2;
    for (int i = 1; i < 2000; ++i) {
      const auto found = sliders_with_offset(task, most * i / 2000);
      if (!found.designs.empty()) sampled = std::min(sampled, found.designs[0].pressure);
    }
    EXPECT_LE(least, sampled + 1e-14) << ratio;
    EXPECT_GE(least, sampled - 1e-3) << ratio;
  }
}

TEST(QuickReturnGuide, HasTheTimeRatio) {
  for (const double ratio : {1.0001, 1.3, 2.0, 5.0, 100.0}) {
    const double theta = pi * (ratio - 1) / (ratio + 1);
    const auto plain = guides_with_frame(ratio, 380, 0);
    ASSERT_EQ(plain.size(), 1U) << ratio;
    EXPECT_NEAR(plain[0].mechanism.crank, 380 * std::sin(theta / 2), 1e-12);
    EXPECT_NEAR(*time_ratio(plain[0].mechanism) / ratio, 1, 1e-9);
    const double offset = 0.7 * guide_offset_limit(ratio, 380);
    const auto aside = guides_with_frame(ratio, 380, offset);
    ASSERT_EQ(aside.size(), 2U) << ratio;
    for (const QuickReturnGuide& guide : aside) {
      EXPECT_NEAR(*swing(guide.mechanism), theta, 1e-7);
      const auto back = guides_with_crank(ratio, guide.mechanism.crank, offset);
      ASSERT_EQ(back.size(), 2U) << ratio;
      EXPECT_NEAR(back[0].mechanism.pivot_a.y, 380, 1e-10);
      // The slow stroke takes the crank counter-clockwise from the right limit to the left one.
      const double slow = std::remainder(guide.left - guide.right, 2 * pi);
      EXPECT_NEAR(slow < 0 ? slow + 2 * pi : slow, pi + theta, 1e-7);
    }
    EXPECT_TRUE(guides_with_frame(ratio, 380, 1.01 * guide_offset_limit(ratio, 380)).empty());
  }
  EXPECT_TRUE(guides_with_frame(1, 380, 0).empty());
  EXPECT_TRUE(guides_with_crank(1, 380, 0).empty());
}

/// Li & Xu 2011, example 1-4: crank 0.125, frame 0.275, bar 0.6, rod 0.15, ram at 0.575.
TEST(QuickReturnShaper, PublishedExample) {
  const double theta = 2 * std::asin(5.0 / 11);
  const double ratio = (pi + theta) / (pi - theta);
  const auto found = shaper({ratio, 1.2 * 5 / 11, 0.275, {}, 0.15, {}, 0.575});
  ASSERT_EQ(found.outcome, ShaperOutcome::solved);
  EXPECT_NEAR(found.shaper.crank, 0.125, 1e-15);
  EXPECT_NEAR(found.shaper.bar, 0.6, 1e-15);
  const auto motion = simulate(found.shaper);
  ASSERT_TRUE(motion);
  EXPECT_NEAR(motion->stroke, 1.2 * 5 / 11, 1e-13);
  EXPECT_NEAR(motion->time_ratio, ratio, 1e-12);
}

TEST(QuickReturnShaper, DoesWhatIsWantedAndLeansLeastInTheMiddle) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> ratio(1.1, 2.6), share(0.1, 0.5);
  for (int i = 0; i < 30; ++i) {
    const ShaperTask task{ratio(random), 0.4, 0.3, {}, {}, share(random), {}};
    const auto best = shaper(task);
    ASSERT_EQ(best.outcome, ShaperOutcome::solved);
    const auto motion = simulate(best.shaper);
    ASSERT_TRUE(motion);
    EXPECT_NEAR(motion->stroke, 0.4, 1e-12);
    EXPECT_NEAR(motion->time_ratio, task.time_ratio, 1e-10);
    EXPECT_NEAR(best.shaper.pressure, *task.pressure, 1e-14);
    for (const double off : {-0.01, 0.01}) {
      const auto other = shaper({task.time_ratio,
                                 0.4,
                                 0.3,
                                 {},
                                 best.shaper.rod,
                                 {},
                                 best.shaper.ram_height + off * best.shaper.rod});
      EXPECT_GT(other.shaper.pressure, best.shaper.pressure);
    }
  }
}

TEST(QuickReturnShaper, Refusals) {
  EXPECT_EQ(shaper({1, 0.4, 0.3, {}, 0.2, {}, {}}).outcome, ShaperOutcome::no_swing);
  EXPECT_EQ(shaper({1.8, 0.4, 0.3, {}, 0.001, {}, {}}).outcome, ShaperOutcome::short_rod);
  const ShaperTask lean{2.5, 0.4, 0.3, {}, {}, 1.4, 0.4};
  const auto found = shaper(lean);
  EXPECT_EQ(found.outcome, ShaperOutcome::overshoot);
  const auto motion = simulate(found.shaper);
  EXPECT_FALSE(motion && std::abs(motion->stroke - 0.4) < 1e-6);
}

}  // namespace
}  // namespace cognate::synthesis::quick_return_slider_test
