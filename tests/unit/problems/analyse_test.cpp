// The table of an analysis against closed forms and published numbers, and what becomes of it where
// the mechanism does not close, is not requested, or the run is ended.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>

#include "analysis/numbers/constants.hpp"
#include "problems/evaluation/result.hpp"
#include "tests/support/named_mechanisms.hpp"

namespace cognate::problems::analyse_test {
namespace {

const FourBar kCrankRocker{{1, 2}, {5, 3}, 1, 4, 3, Assembly::open, Vec2d{2, 0.5}};

AnalysisResult analyse(const AnalysisProblem& problem, int threads = 1) {
  return problems::analyse(problem, problems::Run{.threads = threads});
}

const std::vector<double>& values(const AnalysisResult& result, const std::string& name) {
  static const std::vector<double> empty;
  const auto found = std::ranges::find(result.columns, name, &Column::name);
  EXPECT_NE(found, result.columns.end()) << "no column " << name;
  return found == result.columns.end() ? empty : found->values;
}

std::vector<std::string> names(const AnalysisResult& result) {
  std::vector<std::string> all;
  for (const auto& column : result.columns) all.push_back(column.name);
  return all;
}

bool bitwise_equal(const AnalysisResult& a, const AnalysisResult& b) {
  const auto same = [](double x, double y) {
    return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
  };
  return std::ranges::equal(a.columns, b.columns, [&](const Column& x, const Column& y) {
    return x.name == y.name && std::ranges::equal(x.values, y.values, same);
  });
}

template <class Value>
Value quantity(const AnalysisResult& result, const std::string& name) {
  const auto found = std::ranges::find(result.quantities, name, &Quantity::name);
  if (found == result.quantities.end()) {
    ADD_FAILURE() << "no fact " << name;
    return {};
  }
  return std::get<Value>(found->value);
}

TEST(Analyse, FourBarHasTheColumnsAskedForInAFixedOrder) {
  auto problem = analysis_of(named(kCrankRocker), 4);
  problem.output.curvature = true;
  problem.output.reactions = true;
  problem.output.torque = true;
  problem.output.points = {4};
  const std::vector<std::string> wanted = {"crank_deg",
                                           "coupler_deg",
                                           "coupler_omega_rad_s",
                                           "coupler_alpha_rad_s2",
                                           "rocker_deg",
                                           "rocker_omega_rad_s",
                                           "rocker_alpha_rad_s2",
                                           "P_x",
                                           "P_y",
                                           "P_vx_per_s",
                                           "P_vy_per_s",
                                           "P_ax_per_s2",
                                           "P_ay_per_s2",
                                           "P_curvature",
                                           "transmission_deg",
                                           "torque_N_m",
                                           "A_on_crank_Fx_N",
                                           "A_on_crank_Fy_N",
                                           "B_on_coupler_Fx_N",
                                           "B_on_coupler_Fy_N",
                                           "C_on_rocker_Fx_N",
                                           "C_on_rocker_Fy_N",
                                           "D_on_rocker_Fx_N",
                                           "D_on_rocker_Fy_N",
                                           "shaking_Fx_N",
                                           "shaking_Fy_N",
                                           "shaking_moment_N_m"};
  EXPECT_EQ(names(analyse(problem)), wanted);
}

TEST(Analyse, SlidersHaveDisplacementsAndGuidesReactions) {
  auto problem = analysis_of(named(SliderCrank{.crank = 1, .coupler = 3}), 4);
  problem.output = {.velocity = false, .acceleration = false, .reactions = true, .points = {2}};
  const std::vector<std::string> wanted = {"crank_deg",
                                           "coupler_deg",
                                           "slider_s",
                                           "C_x",
                                           "C_y",
                                           "pressure_deg",
                                           "A_on_crank_Fx_N",
                                           "A_on_crank_Fy_N",
                                           "B_on_coupler_Fx_N",
                                           "B_on_coupler_Fy_N",
                                           "C_on_slider_Fx_N",
                                           "C_on_slider_Fy_N",
                                           "frame_on_slider_N",
                                           "frame_on_slider_moment_N_m",
                                           "shaking_Fx_N",
                                           "shaking_Fy_N",
                                           "shaking_moment_N_m"};
  EXPECT_EQ(names(analyse(problem)), wanted);
}

// Li & Xu 2011, example 1-2, recomputed with 30 digits: l₁ = 100 mm, l₂ = 300 mm, ω = 10 rad/s.
TEST(Analyse, SliderCrankAsPublished) {
  auto problem = analysis_of(named(SliderCrank{.crank = 100, .coupler = 300}), 360);
  problem.drive.rate.speed = 10;
  const auto result = analyse(problem);
  const auto expect = [&](const char* column, std::size_t degree, double wanted) {
    EXPECT_NEAR(values(result, column)[degree], wanted, 1e-10 * std::abs(wanted)) << column;
  };
  expect("slider_s", 0, 400);
  expect("slider_s", 30, 382.40652953342465);
  expect("slider_v_per_s", 30, -646.38501094228);
  expect("slider_a_per_s2", 30, -10423.004340563864);
  expect("coupler_deg", 30, -0.16744807921968932 / kDegree);
  expect("coupler_omega_rad_s", 30, -2.9277002188455996);
  expect("coupler_alpha_rad_s2", 30, 15.454249229321446);
  expect("slider_s", 137, 219.00976905611037);
  expect("slider_v_per_s", 137, -511.26746018684736);
}

// Li & Xu 2011, example 1-3, recomputed with 30 digits: l₁ = 0.12 m, l₄ = 0.38 m, ω = 1 rad/s; the
// block slides on a bar that turns.
TEST(Analyse, GuideBarAsPublished) {
  const auto result = analyse(analysis_of(named(GuideBar{{0, 0.38}, {0, 0}, 0.12}), 360));
  const auto expect = [&](const char* column, std::size_t degree, double wanted) {
    EXPECT_NEAR(values(result, column)[degree], wanted, 1e-10 * std::abs(wanted)) << column;
  };
  expect("bar_deg", 0, 1.2649174553900444 / kDegree);
  expect("block_s", 0, 0.3984971769034255);
  expect("block_v_per_s", 0, 0.114429919816097);
  expect("block_a_per_s2", 0, -0.032858969418224325);
  expect("bar_omega_rad_s", 30, 0.18199608610567514);
  expect("bar_alpha_rad_s2", 30, 0.12287882326665972);
  expect("block_s", 30, 0.45210618221829263);
  expect("block_v_per_s", 30, 0.08734841496483428);
  expect("block_a_per_s2", 30, -0.06730663457766287);
}

// s = l₁ cos θ + √(l₂² − (l₁ sin θ − e)²) and sin α = (l₁ sin θ − e)/l₂ along a line at 30°.
TEST(Analyse, OffsetSliderCrankByItsClosedForm) {
  const double e = 0.4, tilt = 30 * kDegree;
  const auto result = analyse(
      analysis_of(named(SliderCrank{{3, -2}, 1, 2.5, e, {std::cos(tilt), std::sin(tilt)}}), 72));
  for (std::size_t row = 0; row <= 72; ++row) {
    const double theta = values(result, "crank_deg")[row] * kDegree - tilt;
    const double sine = (std::sin(theta) - e) / 2.5;
    EXPECT_NEAR(values(result, "slider_s")[row], std::cos(theta) + 2.5 * std::sqrt(1 - sine * sine),
                1e-14);
    EXPECT_NEAR(std::abs(values(result, "pressure_deg")[row] * kDegree), std::abs(std::asin(sine)),
                1e-14);
  }
}

TEST(Analyse, ScotchYokeMovesAsTheCosine) {
  auto problem = analysis_of(named(ScotchYoke{.crank = 2}), 36);
  problem.drive.rate = {.speed = 3, .acceleration = 5};
  const auto result = analyse(problem);
  for (std::size_t row = 0; row <= 36; ++row) {
    const double theta = double(row) * 10 * kDegree;
    EXPECT_NEAR(values(result, "yoke_s")[row], 2 * std::cos(theta), 1e-14);
    EXPECT_NEAR(values(result, "yoke_v_per_s")[row], -6 * std::sin(theta), 1e-14);
    EXPECT_NEAR(values(result, "yoke_a_per_s2")[row], -18 * std::cos(theta) - 10 * std::sin(theta),
                1e-13);
    EXPECT_NEAR(values(result, "block_s")[row], 2 * std::sin(theta), 1e-14);
    EXPECT_NEAR(values(result, "pressure_deg")[row], 0, 1e-13);
  }
}

// The pin B of a crank: a circle, its acceleration l (i α − ω²) e^{iθ}, its curvature 1/l.
TEST(Analyse, PointsMoveAsTheirBodiesDo) {
  auto problem = analysis_of(named(kCrankRocker), 36);
  problem.drive.rate = {.speed = -2, .acceleration = 3};
  problem.output.curvature = true;
  const auto result = analyse(problem);
  for (std::size_t row = 0; row <= 36; ++row) {
    const double theta = double(row) * 10 * kDegree, c = std::cos(theta), s = std::sin(theta);
    EXPECT_NEAR(values(result, "B_x")[row], 1 + c, 1e-14);
    EXPECT_NEAR(values(result, "B_vy_per_s")[row], -2 * c, 1e-14);
    EXPECT_NEAR(values(result, "B_ax_per_s2")[row], -3 * s - 4 * c, 1e-14);
    EXPECT_NEAR(values(result, "B_curvature")[row], 1, 1e-14);
    // C is 3 from D and 4 from B.
    const double x = values(result, "C_x")[row], y = values(result, "C_y")[row];
    EXPECT_NEAR(std::hypot(x - 5, y - 3), 3, 1e-14);
    EXPECT_NEAR(std::hypot(x - 1 - c, y - 2 - s), 4, 1e-14);
  }
}

TEST(Analyse, AnglesGoOnFromTurnToTurn) {
  const FourBar double_crank{{0, 0}, {1, 0}, 3, 3.2, 3.1, Assembly::open, std::nullopt};
  auto problem = analysis_of(named(double_crank), 144);
  problem.drive.end = 2 * kTurn;
  problem.output = {.velocity = false, .acceleration = false};
  const auto result = analyse(problem);
  const auto& rocker = values(result, "rocker_deg");
  EXPECT_GT(rocker.front(), -180);
  EXPECT_LE(rocker.front(), 180);
  EXPECT_NEAR(rocker.back() - rocker.front(), 720, 1e-10);
  EXPECT_TRUE(std::ranges::is_sorted(rocker));
}

TEST(Analyse, RowsThatDoNotCloseAreEmptyAndExplained) {
  // |B − D| reaches 4 at the crank angle 180°, more than 1.5 + 2: closed up to 3.5.
  const FourBar triple_rocker{{0, 0}, {2, 0}, 2, 1.5, 2, Assembly::open, std::nullopt};
  const auto result = analyse(analysis_of(named(triple_rocker), 360));
  EXPECT_EQ(result.status, Status::solved);
  const double limit = 2 * std::asin(3.5 / 4) / kDegree;
  int closed = 0;
  for (std::size_t row = 0; row <= 360; ++row) {
    const double crank = values(result, "crank_deg")[row];
    EXPECT_EQ(crank, double(row));
    const bool closes = (crank > 2 * std::asin(0.5 / 4) / kDegree && crank < limit) ||
                        (crank > 360 - limit && crank < 360 - 2 * std::asin(0.5 / 4) / kDegree);
    closed += closes ? 1 : 0;
    for (const auto& column : result.columns) {
      if (column.name != "crank_deg") {
        EXPECT_EQ(std::isnan(column.values[row]), !closes) << column.name << crank;
      }
    }
  }
  EXPECT_EQ(result.closed_rows, closed);
  ASSERT_GE(result.notes.size(), 3u);
  EXPECT_NE(result.notes[1].find("from crank angle 123° to 237°"), std::string::npos)
      << result.notes[1];
  EXPECT_NE(result.notes[1].find("dyad C"), std::string::npos) << result.notes[1];
  EXPECT_NE(result.notes[1].find("are 4 apart"), std::string::npos) << result.notes[1];
  EXPECT_NE(result.notes[1].find("reach 3.5"), std::string::npos) << result.notes[1];
}

TEST(Analyse, NothingThatClosesIsNoSolution) {
  const auto result =
      analyse(analysis_of(named(FourBar{{0, 0}, {9, 0}, 1, 2, 3, Assembly::open, {}}), 8));
  EXPECT_EQ(result.status, Status::no_solution);
  EXPECT_EQ(result.closed_rows, 0);
  ASSERT_EQ(result.notes.size(), 1u);
  EXPECT_NE(result.notes[0].find("are 10 apart"), std::string::npos) << result.notes[0];
}

TEST(Analyse, TheNumberOfThreadsChangesNoBit) {
  auto problem = analysis_of(named(kCrankRocker), 3000);
  problem.output.reactions = true;
  problem.inertias[2] = {.mass = 2, .centre = {1, 0}, .moment = 0.3};
  const auto one = analyse(problem, 1);
  for (const int threads : {2, 3, 7}) EXPECT_TRUE(bitwise_equal(one, analyse(problem, threads)));
}

TEST(Analyse, WhatIsNotAskedForIsSkipped) {
  auto problem = analysis_of(named(kCrankRocker), 10);
  problem.output = {.velocity = false, .acceleration = false, .transmission = false, .points = {4}};
  const auto result = analyse(problem);
  EXPECT_EQ(names(result),
            (std::vector<std::string>{"crank_deg", "coupler_deg", "rocker_deg", "P_x", "P_y"}));
  EXPECT_EQ(result.work.positions, 11u);
  EXPECT_EQ(result.work.velocities, 0u);
  EXPECT_EQ(result.work.accelerations, 0u);
  EXPECT_EQ(result.work.reactions, 0u);
  EXPECT_EQ(result.work.skipped,
            (std::vector<std::string>{"velocities", "accelerations", "third derivatives",
                                      "curvature", "transmission", "torque", "reactions"}));
  problem.output.velocity = true;
  EXPECT_EQ(analyse(problem).work.velocities, 11u);
  EXPECT_EQ(analyse(problem).work.accelerations, 0u);
}

// With a massless coupler what the crank exerts on it at B it exerts on the rocker at C, along the
// line B–C; the torque on a massless crank is r × F.
TEST(Analyse, ReactionsActOnTheBodyTheyName) {
  auto problem = analysis_of(named(kCrankRocker), 36);
  problem.output.reactions = true;
  problem.output.torque = true;
  problem.loads = {{.at = {3, {0, 0}}, .torque = -7}};
  const auto result = analyse(problem);
  for (std::size_t row = 0; row <= 36; ++row) {
    const auto at = [&](const char* name) { return values(result, name)[row]; };
    const Vec2d force{at("B_on_coupler_Fx_N"), at("B_on_coupler_Fy_N")};
    const Vec2d b{at("B_x"), at("B_y")}, c{at("C_x"), at("C_y")};
    EXPECT_NEAR(at("C_on_rocker_Fx_N"), force.x, 1e-12);
    EXPECT_NEAR(at("C_on_rocker_Fy_N"), force.y, 1e-12);
    EXPECT_NEAR(cross(c - b, force), 0, 1e-12);
    EXPECT_NEAR(cross(c - Vec2d{5, 3}, force), 7, 1e-12);
    EXPECT_NEAR(at("torque_N_m"), cross(b - Vec2d{1, 2}, force), 1e-12);
    EXPECT_NEAR(at("D_on_rocker_Fx_N"), -force.x, 1e-12);
  }
  EXPECT_LT(quantity<double>(result, "power_residual"), 1e-14);
}

// A slider on the x axis pushed by P along it: the guide bears P tan α across, α the pressure
// angle; the torque alone, by virtual work, is the same as that with the reactions.
TEST(Analyse, GuidesBearTheirNormalForce) {
  auto problem = analysis_of(named(SliderCrank{.crank = 1, .coupler = 3}), 36);
  problem.output.reactions = true;
  problem.output.torque = true;
  problem.loads = {{.at = {3, {0, 0}}, .force = {-100, 0}}};
  const auto result = analyse(problem);
  for (std::size_t row = 0; row <= 36; ++row) {
    const double slope = std::asin(std::sin(double(row) * 10 * kDegree) / 3);
    EXPECT_NEAR(values(result, "frame_on_slider_N")[row], 100 * std::tan(slope), 1e-12);
    EXPECT_NEAR(values(result, "frame_on_slider_moment_N_m")[row], 0, 1e-12);
  }
  problem.output.reactions = false;
  const auto alone = analyse(problem);
  for (std::size_t row = 0; row <= 36; ++row) {
    EXPECT_NEAR(values(alone, "torque_N_m")[row], values(result, "torque_N_m")[row], 1e-12);
  }
  EXPECT_NEAR(quantity<double>(alone, "torque_N_m.max"), quantity<double>(result, "torque_N_m.max"),
              1e-12);
}

TEST(Analyse, ClosesToRounding) {
  for (const auto& mechanism :
       {named(kCrankRocker), named(SliderCrank{{1, 1}, 1, 3, 0.5, {0.6, 0.8}}),
        named(GuideBar{{0, 0}, {3, 1}, 1, 0.5}), named(ScotchYoke{.crank = 2, .offset = 0.3}),
        named(EllipticTrammel{.length = 2, .direction = {0.6, 0.8}})}) {
    const auto result = analyse(analysis_of(mechanism, 90));
    EXPECT_EQ(result.closed_rows, 91);
    EXPECT_LT(quantity<double>(result, "closure_residual"), 4e-15);
  }
}

TEST(Analyse, ADeadPointLeavesNoInfinity) {
  // At 0° B and D are 1 apart, l₃ − l₂ = 1: folded, the coupler's velocity is unbounded there.
  const FourBar folded{{0, 0}, {2, 0}, 1, 1, 2, Assembly::open, std::nullopt};
  const auto result = analyse(analysis_of(named(folded), 4));
  for (const auto& column : result.columns) {
    for (const double value : column.values) EXPECT_FALSE(std::isinf(value)) << column.name;
  }
  EXPECT_FALSE(std::isnan(values(result, "rocker_deg").front()));
}

TEST(Analyse, AnInterruptedRunKeepsWhatItHas) {
  const std::atomic<bool> interrupted{true};
  const auto result = problems::analyse(analysis_of(named(kCrankRocker), 100),
                                        problems::Run{.threads = 1, .interrupted = &interrupted});
  EXPECT_EQ(result.status, Status::interrupted);
  EXPECT_EQ(result.columns.front().values.size(), 0u);
}

TEST(Analyse, NothingIsSaidOfAMotionThatWasNotFollowedToItsEnd) {
  std::atomic<bool> interrupted{false};
  const auto analysed = [&](bool interrupts) {
    interrupted = false;
    return problems::analyse(
        analysis_of(named(kCrankRocker), 100),
        problems::Run{
            .threads = 1, .interrupted = &interrupted, .progress = [&](double share, double) {
              if (share == 1) interrupted = interrupts;
            }});
  };
  EXPECT_FALSE(analysed(false).landmarks.empty());
  const auto result = analysed(true);
  EXPECT_EQ(result.status, Status::interrupted);
  EXPECT_EQ(result.columns.front().values.size(), 101u);
  EXPECT_TRUE(result.landmarks.empty());
}

TEST(Analyse, ARunThatIsEndedKeepsItsFirstRows) {
  std::atomic<bool> interrupted{false};
  const auto result = problems::analyse(
      analysis_of(named(kCrankRocker), 5000),
      problems::Run{
          .threads = 1, .interrupted = &interrupted, .progress = [&](double share, double) {
            if (share > 0.5) interrupted = true;
          }});
  EXPECT_EQ(result.status, Status::interrupted);
  const std::size_t rows = result.columns.front().values.size();
  EXPECT_GT(rows, 2500u);
  EXPECT_LT(rows, 5000u);
  EXPECT_EQ(result.work.positions, rows);
  EXPECT_EQ(static_cast<std::size_t>(result.closed_rows), rows);
}

TEST(Analyse, ATimeLimitEndsTheRun) {
  const auto result = problems::analyse(analysis_of(named(kCrankRocker), 100),
                                        problems::Run{.threads = 1, .time_limit = 1e-12});
  EXPECT_EQ(result.status, Status::time_limit);
}

}  // namespace
}  // namespace cognate::problems::analyse_test
