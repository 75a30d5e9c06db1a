// The report's data: sampled motion, structural error, and how text is embedded.

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "analysis/numbers/constants.hpp"
#include "app/documents/result_json.hpp"
#include "app/drawing/design_motion.hpp"
#include "app/kinds/kinds.hpp"
#include "app/report/function_trace.hpp"

namespace cognate::app::report_test {
namespace {

Vec2d polar(double length, double angle) {
  return {length * std::cos(angle), length * std::sin(angle)};
}

double coupler_length(const FourBar& linkage, double crank, double rocker) {
  const Vec2d b = linkage.pivot_a + polar(linkage.crank, crank);
  const Vec2d c = linkage.pivot_d + polar(linkage.rocker, rocker);
  return std::sqrt(squared_norm(c - b));
}

TEST(DesignMotion, ClosesTheLoopAtEverySampleOfAFullTurn) {
  const FourBar linkage{
      .pivot_a = {1, 2}, .pivot_d = {4, 3}, .crank = 1, .coupler = 3, .rocker = 2.5};
  const auto motion = sample_motion(linkage, {}, 361);
  ASSERT_EQ(motion.crank.size(), 361u);
  EXPECT_TRUE(motion.full_turn);
  EXPECT_DOUBLE_EQ(motion.crank.front(), 0);
  EXPECT_DOUBLE_EQ(motion.crank.back(), kTurn);
  for (std::size_t i = 0; i < motion.crank.size(); ++i) {
    EXPECT_NEAR(coupler_length(linkage, motion.crank[i], motion.rocker[i]), 3, 1e-13);
  }
  EXPECT_NEAR(motion.rocker.back(), motion.rocker.front(), 1e-13);
}

TEST(DesignMotion, FollowsARockerThatTurnsFullyWithoutAJump) {
  const FourBar drag_link{.pivot_d = {1, 0}, .crank = 3, .coupler = 2.5, .rocker = 3.2};
  const auto motion = sample_motion(drag_link, {}, 181);
  ASSERT_EQ(motion.rocker.size(), 181u);
  EXPECT_NEAR(std::abs(motion.rocker.back() - motion.rocker.front()), kTurn, 1e-12);
  for (std::size_t i = 1; i < motion.rocker.size(); ++i) {
    EXPECT_LT(std::abs(motion.rocker[i] - motion.rocker[i - 1]), 0.3);
  }
}

// A rocker-crank closes in two ranges, mirror images in A–D. At their ends coupler and rocker are
// collinear: |B − D| is the sum or the difference of their lengths.
TEST(DesignMotion, TakesTheRangeInWhichTheDesignIsUsed) {
  const FourBar linkage{.pivot_d = {3, 0}, .crank = 2.5, .coupler = 3, .rocker = 1};
  for (const double used : {0.9, -0.9 + kTurn}) {
    const auto motion = sample_motion(linkage, std::vector{used}, 91);
    ASSERT_GE(motion.crank.size(), 89u);
    EXPECT_FALSE(motion.full_turn);
    EXPECT_LE(motion.crank.front(), used);
    EXPECT_GE(motion.crank.back(), used);
    for (const auto& [crank, distance] : {std::pair{motion.crank.front(), used < kPi ? 2.0 : 4.0},
                                          std::pair{motion.crank.back(), used < kPi ? 4.0 : 2.0}}) {
      EXPECT_NEAR(std::sqrt(squared_norm(polar(2.5, crank) - Vec2d{3, 0})), distance, 1e-9);
    }
  }
}

TEST(DesignMotion, IsEmptyWhereTheLinksNeverClose) {
  const FourBar linkage{.pivot_d = {10, 0}, .crank = 1, .coupler = 1, .rocker = 1};
  EXPECT_TRUE(sample_motion(linkage, {}, 11).crank.empty());
}

// y = x on a parallelogram with equal ranges is generated exactly; an output start that is off by
// 0.01 is an error of −0.01 everywhere.
TEST(FunctionTrace, GivesTheStructuralErrorOverTheDomain) {
  problems::FunctionOfX identity{.text = "x", .table = {}, .y = [](double x) { return x; }};
  identity.domain = {2, 3};
  identity.input_range = identity.output_range = 0.8;
  problems::FunctionProblem problem;
  problem.target = identity;
  problems::Design design;
  design.mechanism = problems::named(FourBar{
      .pivot_d = {2, 0}, .crank = 1, .coupler = 2, .rocker = 1, .assembly = Assembly::open});
  design.metrics.input_start = 0.7;
  design.metrics.output_start = 0.71;
  const auto trace = function_trace(problem, problems::function_samples(problem), design);
  ASSERT_GT(trace.x.size(), 100u);
  EXPECT_DOUBLE_EQ(trace.x.front(), 2);
  EXPECT_DOUBLE_EQ(trace.x.back(), 3);
  EXPECT_DOUBLE_EQ(trace.crank.back(), 1.5);
  for (const double error : trace.error) EXPECT_NEAR(error, -0.01, 1e-13);
}

TEST(ReportData, RoundsToSignificantDigits) {
  EXPECT_EQ(round_to_digits(123.4567891, 7), 123.4568);
  EXPECT_EQ(round_to_digits(-1.23456789e-9, 3), -1.23e-9);
  EXPECT_EQ(round_to_digits(0, 7), 0);
}

TEST(ReportData, HoldsAClosedTargetAndWhereItCame) {
  problems::PathProblem problem;
  std::vector<Vec2d> vertices;
  for (int k = 0; k < 5000; ++k) vertices.push_back(polar(2, kTurn * k / 5000));
  problem.curve = problems::TargetCurve{problems::ClosedCurve(vertices), {}, {}};
  problem.points = problem.curve->curve.equally_spaced(12);
  problems::Result result;
  result.designs.resize(2);
  for (problems::Design& design : result.designs) {
    design.mechanism = problems::named(FourBar{
        .pivot_d = {4, 0}, .crank = 1, .coupler = 3, .rocker = 3.5, .coupler_point = Vec2d{1, 1}});
  }
  result.designs[1].placement = problems::CurvePlacement{3, kPi / 6, {5, 7}};
  const auto data = Kind<problems::PathProblem>::report_data(problem, result);
  const auto& drawn = data["target"]["curve"];
  ASSERT_EQ(drawn.size(), 1000u);  // in even steps around the whole
  EXPECT_NEAR(drawn[500][0].get<double>(), -2, 1e-4);
  EXPECT_FALSE(data["designs"][0].contains("placement"));
  const auto& placement = data["designs"][1]["placement"];
  EXPECT_EQ(placement["scale"], 3);
  EXPECT_NEAR(placement["deg"].get<double>(), 30, 1e-12);
  EXPECT_EQ(placement["shift"], nlohmann::ordered_json({5, 7}));
}

TEST(Report, EmbedsTheDocumentExactlyAndNothingThatEndsIt) {
  problems::PathProblem problem;
  problem.title = "</script><!-- \u2028 \xff & 0.1";
  problem.points = {{0, 0}, {1, 0.1}, {2, 1.0 / 3}};
  const problems::Result result{.notes = {"<script>"}};
  const auto document = result_document(problem, result, 7);
  ASSERT_TRUE(document.has_value());
  const std::string html = report_html(*document, problem, result);
  const std::string opening = R"(<script type="application/json" id="data">)";
  const auto begin = html.find(opening) + opening.size();
  const auto end = html.find("</script>", begin);
  const std::string json = html.substr(begin, end - begin);
  EXPECT_EQ(json.find('<'), std::string::npos);
  EXPECT_EQ(html.find("<!-- "), std::string::npos);
  const auto data = nlohmann::ordered_json::parse(json);
  EXPECT_EQ(data["result"], nlohmann::ordered_json::parse(write_json(*document)));
  EXPECT_EQ(data["target"]["points"][2][1], 1.0 / 3);
}

}  // namespace
}  // namespace cognate::app::report_test
