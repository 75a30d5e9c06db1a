// What the report draws of designs of any type: the part of the drive, the body that is guided.
#include "app/report/design_drawing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

#include "analysis/linkage/four_bar.hpp"
#include "analysis/mechanism/kinematics.hpp"
#include "analysis/numbers/constants.hpp"
#include "app/report/drawn_findings.hpp"
#include "app/report/guided_body.hpp"
#include "problems/linkage/drive_span.hpp"
#include "tests/support/planted_result.hpp"

namespace cognate::app::design_drawing_test {
namespace {

using problems::drive_span;
using synthesis::Pose;

const FourBar kRockerCrank{.pivot_d = {3, 0}, .crank = 2.5, .coupler = 3, .rocker = 1};

Vec2d polar(double length, double angle) {
  return {length * std::cos(angle), length * std::sin(angle)};
}

TEST(DriveSpan, IsTheWholeTurnOfACrankThatTurnsFully) {
  const SliderCrank mechanism{.crank = 1, .coupler = 3, .offset = 0.5};
  const auto span = drive_span(as_mechanism(mechanism), {});
  ASSERT_TRUE(span);
  EXPECT_TRUE(span->round);
  EXPECT_NEAR(span->to - span->from, kTurn, 1e-12);
}

// The range ends where coupler and rocker are in line: |B − D| is 2 or 4.
TEST(DriveSpan, HoldsMostOfTheStationsInWhateverTurn) {
  for (const double turn : {0.0, -kTurn, 4 * kPi}) {
    for (const double side : {1.0, -1.0}) {
      const std::vector<double> stations = {side * 0.9 + turn, side * 1.1, -side * 0.9};
      const auto span = drive_span(as_mechanism(kRockerCrank), stations);
      ASSERT_TRUE(span);
      EXPECT_FALSE(span->round);
      const double middle = std::remainder(0.5 * (span->from + span->to), kTurn);
      EXPECT_GT(side * middle, 0);
      for (const double end : {span->from, span->to}) {
        const double away = std::sqrt(squared_norm(polar(2.5, end) - Vec2d{3, 0}));
        EXPECT_NEAR(std::abs(away - 3), 1, 1e-4);
      }
    }
  }
}

TEST(DriveSpan, OfADrivingSliderReachesBeyondItsStations) {
  Mechanism<double> mechanism{.drive = DrivingSlider<double>{}};
  mechanism.dyads.push_back(Rpr<double>{.block = {1, {}}, .pivot = {0, {0, 5}}});
  const auto span = drive_span(mechanism, std::vector{2.0, 3.0, 2.5});
  ASSERT_TRUE(span);
  EXPECT_DOUBLE_EQ(span->from, 1.75);
  EXPECT_DOUBLE_EQ(span->to, 3.25);
  EXPECT_FALSE(drive_span(mechanism, {}));
}

TEST(DriveSpan, IsEmptyWhereNothingCloses) {
  const FourBar apart{.pivot_d = {10, 0}, .crank = 1, .coupler = 1, .rocker = 1};
  EXPECT_FALSE(drive_span(as_mechanism(apart), {}));
}

// Axes anywhere in any body of a mechanism are found again from the poses they take alone.
TEST(GuidedBody, IsTheOneThatTakesThePoses) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-2, 2);
  const std::vector<double> stations = {0.2, 1.1, 2.5, 4.0};
  const std::vector<problems::NamedMechanism> mechanisms = {
      problems::named(FourBar{.pivot_d = {4, 0.5}, .crank = 1, .coupler = 3.4, .rocker = 2.6}),
      problems::named(SliderCrank{.crank = 1, .coupler = 3, .offset = 0.2}),
      problems::named(OscillatingBlock{.pivot_c = {3, 1}, .crank = 1, .offset = 0.25})};
  for (const auto& mechanism : mechanisms) {
    const Pose in_body{{number(random), number(random)}, number(random)};
    std::vector<Pose> targets;
    MechanismMotion<0> motion(mechanism.mechanism);
    for (const double at : stations) {
      ASSERT_TRUE(motion.move_to(at));
      const auto& body = motion.bodies()[2];
      const double angle = std::atan2(body.direction.y, body.direction.x);
      targets.push_back({point_motion(body, in_body.at)[0], angle + in_body.angle});
    }
    const auto guided = guided_body(mechanism, stations, targets);
    ASSERT_TRUE(guided);
    for (std::size_t k = 0; k < targets.size(); ++k) {
      ASSERT_TRUE(guided->reached[k]);
      const Vec2d away = to_frame(*guided->reached[k], guided->target_in_body.at) - targets[k].at;
      EXPECT_LT(std::hypot(away.x, away.y), 1e-13);
    }
    EXPECT_EQ(guided->body, 2);
  }
}

TEST(GuidedBody, SaysWhereAPoseIsNotReached) {
  const auto mechanism = problems::named(kRockerCrank);
  const std::vector<Pose> targets = {{{1, 1}, 0}, {{2, 1}, 0.3}};
  const auto guided = guided_body(mechanism, std::vector{0.9, kPi}, targets);
  ASSERT_TRUE(guided);
  EXPECT_TRUE(guided->reached[0]);
  EXPECT_FALSE(guided->reached[1]);
  EXPECT_FALSE(guided_body(mechanism, std::vector{kPi}, std::vector<Pose>(1)));
  EXPECT_FALSE(guided_body(mechanism, std::vector{0.9}, targets));
}

TEST(DesignDrawing, TakesFewerSamplesOfManyDesigns) {
  EXPECT_EQ(fineness(1).linkage, 361);
  EXPECT_EQ(fineness(0).mechanism, 361);
  EXPECT_GE(fineness(1'000'000).linkage, 91);
  EXPECT_LT(200 * fineness(200).linkage, 30'000);
}

TEST(DesignDrawing, HoldsNoPictureOfWhatCannotBeAssembled) {
  problems::Design design;
  design.mechanism = problems::named(SliderCrank{.crank = 1, .coupler = 1, .offset = 5});
  const auto drawn = motion_of(design, fineness(1));
  EXPECT_TRUE(drawn["mechanism"].is_null());
  EXPECT_TRUE(drawn["drive"].is_null());
}

TEST(DrawnFindings, ThinsCurvesToTheirEnds) {
  problems::Locus locus{.name = "long", .branches = {{}, {{1, 2}}}};
  for (int i = 0; i <= 50'000; ++i) locus.branches[0].push_back({0.5 * i, 1});
  const auto loci = drawn_loci(std::vector{locus});
  const auto& points = loci[0]["branches"][0];
  EXPECT_LT(points.size(), 7000u);
  EXPECT_GT(points.size(), 3000u);
  EXPECT_EQ(points.front(), nlohmann::ordered_json({0.0, 1.0}));
  EXPECT_EQ(points.back(), nlohmann::ordered_json({25000.0, 1.0}));
  EXPECT_EQ(loci[0]["branches"][1].size(), 1u);
}

TEST(DrawnFindings, LeavesGapsWhereThereIsNoNumber) {
  const auto planted = problems::planted_synthesis();
  EXPECT_TRUE(drawn_loci(planted.loci)[0]["branches"][0][2].is_null());
  const auto families = drawn_families(planted.families);
  EXPECT_TRUE(families[0]["columns"][1]["values"][1].is_null());
}

}  // namespace
}  // namespace cognate::app::design_drawing_test
