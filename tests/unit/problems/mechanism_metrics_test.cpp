// Metrics of mechanisms that are no four-bars, against closed forms of their dimensions; a four-bar
// stands in as a chain for the oracle of defects.

#include "problems/evaluation/mechanism_metrics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "analysis/linkage/slider_crank_mobility.hpp"
#include "analysis/mechanism/kinematics.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/linkage/verify.hpp"

namespace cognate::problems::mechanism_metrics_test {
namespace {

const SliderCrank kRotating{
    .pivot = {3, -2}, .crank = 1, .coupler = 3, .offset = 0.5, .direction = {0.6, 0.8}};
// The line is so far away that the crank turns over a part of its circle alone.
const SliderCrank kSwinging{.pivot = {0, 0}, .crank = 2, .coupler = 1.5, .offset = 1};

DriveState at(double drive, double side = 1) {
  return {drive, {side}};
}

Metrics metrics_of(const MechanismDescription& what, const std::vector<DriveState>& states) {
  return mechanism_metrics(named(what), states, PointOrder::cyclic);
}

TEST(MechanismMetricsTest, RotatingSliderCrankByItsClosedForms) {
  const Metrics metrics = metrics_of(kRotating, {at(0.3), at(2), at(4)});
  const auto pressure = pressure_angles(kRotating);
  ASSERT_TRUE(pressure && metrics.time_ratio);
  EXPECT_NEAR(metrics.transmission_acute_min, kRightAngle - std::abs(pressure->steepest), 1e-12);
  EXPECT_NEAR(*metrics.time_ratio, time_ratio(kRotating).value(), 1e-12);
  EXPECT_TRUE(metrics.defects.empty());
  EXPECT_FALSE(metrics.mobility);
}

TEST(MechanismMetricsTest, DefectsOfATurningCrank) {
  EXPECT_EQ(metrics_of(kRotating, {at(0.3), at(2, -1)}).defects,
            (std::vector{Defect::circuit, Defect::branch}));
  EXPECT_EQ(metrics_of(kRotating, {at(0), at(3), at(1), at(2)}).defects,
            std::vector{Defect::order});
  EXPECT_TRUE(metrics_of(kRotating, {at(6), at(4), at(2), at(0.5)}).defects.empty());
}

TEST(MechanismMetricsTest, DefectsOfASwingingCrank) {
  const auto ranges = crank_ranges(kSwinging);
  ASSERT_EQ(ranges.size(), 1U);
  const double from = ranges[0].from, way = ranges[0].to - ranges[0].from;
  EXPECT_TRUE(metrics_of(kSwinging, {at(from + 0.2 * way), at(from + 0.7 * way)}).defects.empty());
  EXPECT_EQ(metrics_of(kSwinging, {at(from + 0.2 * way), at(from + 0.7 * way, -1)}).defects,
            std::vector{Defect::branch});
  EXPECT_EQ(metrics_of(kSwinging, {at(from + 0.2 * way), at(from - 0.3)}).defects,
            std::vector{Defect::circuit});
  EXPECT_EQ(
      metrics_of(kSwinging, {at(from + 0.2 * way), at(from + 0.7 * way), at(from + 0.4 * way)})
          .defects,
      std::vector{Defect::order});
}

// The range between the states alone counts where the crank swings.
TEST(MechanismMetricsTest, TransmissionOverTheMotionUsed) {
  const auto range = crank_ranges(kSwinging)[0];
  const double middle = (range.from + range.to) / 2;
  const Metrics metrics = metrics_of(kSwinging, {at(middle - 0.1), at(middle + 0.1)});
  const auto pressure = pressure_angles(kSwinging, {middle - 0.1, middle + 0.1});
  ASSERT_TRUE(pressure);
  EXPECT_NEAR(metrics.transmission_acute_min, kRightAngle - std::abs(pressure->steepest), 1e-9);
}

// A four-bar as a chain has the defects that the closed forms of four-bars say.
TEST(MechanismMetricsTest, AgreesWithFourBars) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> length(0.5, 3), angle(0, kTurn), coin(-1, 1);
  int unsound = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const FourBar linkage{
        {0, 0}, {length(random), 0}, length(random), length(random), length(random)};
    NamedMechanism chain = named(linkage);
    std::vector<CrankPosition> positions;
    std::vector<DriveState> states;
    MechanismMotion<0> motion(chain.mechanism);
    while (positions.size() < 3) {
      if (angle(random) < 0.01) break;  // a linkage that closes nowhere
      const double drive = angle(random), side = coin(random) < -0.8 ? -1 : 1;
      if (!motion.move_to(drive)) continue;
      positions.push_back({drive, side < 0 ? Assembly::crossed : Assembly::open});
      states.push_back(at(drive, side));
    }
    if (positions.size() < 3 || positions[0].side == Assembly::crossed) continue;
    const auto expected = design_metrics(linkage, std::span<const CrankPosition>(positions), {});
    chain.description = ChainDescription{};
    const Metrics found = mechanism_metrics(chain, states, PointOrder::cyclic);
    EXPECT_EQ(found.defects, expected.defects) << "trial " << trial;
    unsound += expected.defects.empty() ? 0 : 1;
  }
  EXPECT_GT(unsound, 20);
}

TEST(MechanismMetricsTest, ChecksNameWhatTheyLimit) {
  const NamedMechanism mechanism = named(kRotating);
  const Metrics metrics = metrics_of(kRotating, {at(0.3), at(2, -1)});
  Constraints constraints;
  constraints.required_class = RequiredClass::crank_rocker;
  constraints.link_ratio_max = 2;
  constraints.pivot_region = Box{{0, -3}, {2, 0}};
  Bounds bounds;
  bounds.crank = Range{0.5, 1};
  bounds.frame = Range{1, 2};
  bounds.pivot_a = Box{{2, -1}, {4, 1}};
  bounds.pivot_d = Box{{2, -1}, {4, 1}};
  const auto checks = check_constraints(constraints, bounds, mechanism, metrics);
  const auto satisfied = [&](std::string_view name) {
    const auto found = std::ranges::find(checks, name, &ConstraintCheck::name);
    return found == checks.end() ? -1 : static_cast<int>(found->satisfied);
  };
  EXPECT_EQ(satisfied("class"), 1);
  EXPECT_EQ(satisfied("bounds.crank"), 1);
  EXPECT_EQ(satisfied("bounds.frame"), -1) << "a slider-crank has none";
  EXPECT_EQ(satisfied("bounds.pivot_a.x"), 1);
  EXPECT_EQ(satisfied("bounds.pivot_a.y"), 0);
  EXPECT_EQ(satisfied("bounds.pivot_d.x"), -1) << "nor a second fixed pivot";
  EXPECT_EQ(satisfied("link_ratio_max"), 0);
  EXPECT_EQ(satisfied("pivot_region.A.x"), 0);
  EXPECT_EQ(satisfied("pivot_region.A.y"), 1);
  EXPECT_EQ(satisfied("no_order_defect"), 1);
  EXPECT_EQ(satisfied("no_circuit_defect"), 0);
}

}  // namespace
}  // namespace cognate::problems::mechanism_metrics_test
