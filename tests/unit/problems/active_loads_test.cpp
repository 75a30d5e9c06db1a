/// When loads act: senses, angle intervals, parts of a stroke; and the travel they depend on.
#include "problems/evaluation/active_loads.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/mechanism/kinematics.hpp"
#include "analysis/numbers/constants.hpp"
#include "tests/support/random_chains.hpp"

namespace cognate::problems::active_loads_test {
namespace {

using test::ChainMaker;

constexpr double pi = kPi;
constexpr double degree = pi / 180;

/// Crank 1, coupler 3 and slider on the x axis, which reaches from 2 to 4.
Mechanism<double> slider_crank() {
  Mechanism<double> mechanism;
  mechanism.drive = Crank<double>{{0, 0}, 1};
  mechanism.dyads = {Rrp<double>{{1, {1, 0}}, 3, {0, {0, 0}, {1, 0}, 0}}};
  return mechanism;
}
constexpr int crank = 1, coupler = 2, slider = 3;

/// Whether a single load acts.
bool acts(const Mechanism<double>& mechanism, const LoadRule& rule, double drive, double speed = 1,
          const Stroke& stroke = {}) {
  MechanismMotion<1> motion(mechanism);
  motion.move_to(drive);
  ActiveLoads active(mechanism, {&rule, 1}, {&stroke, 1});
  return !active.at<1>(drive, speed, motion.bodies()).empty();
}

TEST(ActiveLoads, GiveTheLoadAsItIsRuled) {
  const LoadRule rule{.at = {slider, {0.5, 0.25}}, .force = {1, 2}, .torque = 3};
  const Mechanism<double> mechanism = slider_crank();
  MechanismMotion<1> motion(mechanism);
  motion.move_to(1);
  ActiveLoads active(mechanism, {&rule, 1});
  const std::span<const Load> loads = active.at<1>(1, 0, motion.bodies());
  ASSERT_EQ(loads.size(), 1U);
  EXPECT_EQ(loads[0].at.body, slider);
  EXPECT_EQ(loads[0].at.at, (Vec2d{0.5, 0.25}));
  EXPECT_EQ(loads[0].force, (Vec2d{1, 2}));
  EXPECT_EQ(loads[0].torque, 3);
}

TEST(ActiveLoads, SenseIsThatOfTheBodysTravel) {
  // The slider goes back while the crank turns from 0 to 180°; the coupler, from 0 at either end,
  // turns clockwise from -90° to 90°.
  for (int angle = 5; angle < 360; angle += 10) {
    const bool back = angle < 180, clockwise = angle < 90 || angle > 270;
    for (const double speed : {2.0, -2.0}) {
      const bool forward = speed > 0;
      const auto advances = [&](int body) {
        const LoadRule rule{.at = {body, {}}, .sense = LoadSense::advance};
        return acts(slider_crank(), rule, angle * degree, speed);
      };
      const auto retreats = [&](int body) {
        const LoadRule rule{.at = {body, {}}, .sense = LoadSense::retreat};
        return acts(slider_crank(), rule, angle * degree, speed);
      };
      EXPECT_EQ(advances(slider), back != forward) << angle;
      EXPECT_EQ(retreats(slider), back == forward) << angle;
      EXPECT_EQ(advances(coupler), clockwise != forward) << angle;
      EXPECT_EQ(retreats(coupler), clockwise == forward) << angle;
      EXPECT_EQ(advances(crank), forward);
      EXPECT_EQ(retreats(crank), !forward);
    }
  }
}

TEST(ActiveLoads, NothingWithASenseActsAtRest) {
  const LoadRule always{.at = {slider, {}}};
  for (const LoadSense sense : {LoadSense::advance, LoadSense::retreat}) {
    const LoadRule on_slider{.at = {slider, {}}, .sense = sense};
    const LoadRule on_coupler{.at = {coupler, {}}, .sense = sense};
    EXPECT_FALSE(acts(slider_crank(), on_slider, 0));
    EXPECT_FALSE(acts(slider_crank(), on_slider, pi));  // where sin rounds to 1.2e-16
    EXPECT_FALSE(acts(slider_crank(), on_slider, 2 * pi));
    EXPECT_FALSE(acts(slider_crank(), on_coupler, pi / 2));
    EXPECT_FALSE(acts(slider_crank(), on_coupler, 3 * pi / 2));
    EXPECT_FALSE(acts(slider_crank(), on_slider, 1, 0));  // the drive stands still
  }
  EXPECT_TRUE(acts(slider_crank(), always, pi));
  EXPECT_TRUE(acts(slider_crank(), always, 1, 0));
}

TEST(ActiveLoads, BetweenTwoAnglesOfTheDrive) {
  const auto between = [](double from, double to, double drive) {
    const LoadRule rule{.at = {slider, {}}, .between = {{from * degree, to * degree}}};
    return acts(slider_crank(), rule, drive * degree);
  };
  EXPECT_TRUE(between(30, 60, 45));
  EXPECT_TRUE(between(30, 60, 30));
  EXPECT_TRUE(between(30, 60, 60));
  EXPECT_FALSE(between(30, 60, 29.999));
  EXPECT_FALSE(between(30, 60, 60.001));
  EXPECT_TRUE(between(30, 60, 45 - 720));
  EXPECT_TRUE(between(300, 60, 0));
  EXPECT_TRUE(between(-60, 60, 350));
  EXPECT_TRUE(between(-60, 60, 300));
  EXPECT_FALSE(between(300, 60, 180));
  EXPECT_TRUE(between(0, 360, 123));
  EXPECT_TRUE(between(90, 450, 90));
  for (int i = 0; i <= 100; ++i) {
    // An end is met however the sweep came to it.
    EXPECT_TRUE(between(7.3, 91.7, 7.3 + 360 * i));
    EXPECT_TRUE(between(7.3, 91.7, 91.7 - 360 * i));
  }
}

TEST(ActiveLoads, BetweenTwoPositionsOfADrivingSlider) {
  Mechanism<double> mechanism;
  mechanism.drive = DrivingSlider<double>{};
  const LoadRule rule{.at = {1, {}}, .between = {{-0.5, 7}}};
  EXPECT_TRUE(acts(mechanism, rule, -0.5));
  EXPECT_TRUE(acts(mechanism, rule, 6.9));
  EXPECT_FALSE(acts(mechanism, rule, -0.6));
  EXPECT_FALSE(acts(mechanism, rule, 7.1));
}

TEST(ActiveLoads, WithinAPartOfTheStroke) {
  const LoadRule on_slider{.at = {slider, {}}, .within_stroke = {{0.25, 0.75}}};
  const Stroke stroke{2, 4};
  for (int angle = 0; angle < 360; angle += 7) {
    const double c = std::cos(angle * degree), s = std::sin(angle * degree);
    const double part = (c + std::sqrt(9 - s * s) - 2) / 2;
    EXPECT_EQ(acts(slider_crank(), on_slider, angle * degree, 1, stroke),
              0.25 < part && part < 0.75)
        << angle;
  }
  // The coupler swings from -asin 1/3 to asin 1/3.
  const double swing = std::asin(1.0 / 3);
  const LoadRule on_coupler{.at = {coupler, {}}, .within_stroke = {{0, 0.5}}};
  EXPECT_TRUE(acts(slider_crank(), on_coupler, pi / 2, 1, {-swing, swing}));
  EXPECT_TRUE(acts(slider_crank(), on_coupler, pi / 6, 1, {-swing, swing}));
  EXPECT_FALSE(acts(slider_crank(), on_coupler, -pi / 6, 1, {-swing, swing}));
}

TEST(ActiveLoads, StrokeOfAnAngleMayPassTheNegativeXAxis) {
  Mechanism<double> mechanism;
  mechanism.drive = Crank<double>{{0, 0}, 1};
  const Stroke stroke{170 * degree, 210 * degree};
  const LoadRule rule{.at = {1, {}}, .within_stroke = {{0.0, 0.5}}};
  EXPECT_TRUE(acts(mechanism, rule, 170 * degree, 1, stroke));
  EXPECT_TRUE(acts(mechanism, rule, 170 * degree - 1e-14, 1, stroke));
  EXPECT_TRUE(acts(mechanism, rule, 189 * degree, 1, stroke));
  EXPECT_FALSE(acts(mechanism, rule, 191 * degree, 1, stroke));
  EXPECT_FALSE(acts(mechanism, rule, 169 * degree, 1, stroke));
}

/// Rates of all travels in chains of every dyad and drive, by central differences.
TEST(Travel, RateIsTheDerivativeOfWhatIsTravelled) {
  constexpr double step = 1e-5;
  ChainMaker maker(3);
  int compared = 0;
  for (int drive = 0; drive < 3; ++drive) {
    for (int i = 0; i < 25; ++i) {
      const Mechanism<double> mechanism = maker.make(drive, {i / 5, i % 5});
      MechanismMotion<1> motion(mechanism), before(mechanism), after(mechanism);
      if (!motion.move_to(ChainMaker::kStart) || !before.move_to(ChainMaker::kStart - step) ||
          !after.move_to(ChainMaker::kStart + step)) {
        continue;
      }
      for (const Travel& travel : travels(mechanism)) {
        double change =
            travelled<1>(travel, after.bodies()) - travelled<1>(travel, before.bodies());
        if (!travel.slides) change = std::remainder(change, 2 * pi);
        const double rate = travel_rate<1>(travel, motion.bodies());
        EXPECT_NEAR(rate, change / (2 * step), 1e-6 * std::max(1.0, std::abs(rate * rate * rate)));
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 400);
}

TEST(Travel, IsCountedFromTheGuidesPoint) {
  Mechanism<double> mechanism = slider_crank();
  std::get<Rrp<double>>(mechanism.dyads[0]).guide.through = {1.5, 0};
  MechanismMotion<0> motion(mechanism);
  motion.move_to(0);
  EXPECT_EQ(travelled<0>(travels(mechanism)[slider], motion.bodies()), 2.5);
}

}  // namespace
}  // namespace cognate::problems::active_loads_test
