/// Tolerances at the ends of what has figures: one sample, tails that leave nothing of a length,
/// tolerances as large as links, cams that are undercut.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "analysis/numbers/constants.hpp"
#include "problems/cam/problem.hpp"
#include "problems/cam/result.hpp"
#include "problems/evaluation/result.hpp"
#include "problems/linkage/design_tolerances.hpp"
#include "problems/linkage/result.hpp"
#include "problems/quick_return/problem.hpp"
#include "problems/read.hpp"
#include "problems/tolerance/figures.hpp"

namespace cognate::problems::tolerance_limits_test {
namespace {

ToleranceResult of_analysis(const std::string& mechanism, const std::string& tolerance) {
  const auto read =
      parse_task<AnalysisProblem>("kind = \"analysis\"\n[mechanism]\n" + mechanism +
                                  "\n[drive]\nsteps = 12\n[tolerance]\n" + tolerance + "\n");
  if (!read) {
    ADD_FAILURE() << read.error().front().message;
    return {};
  }
  const auto result = analyse(*read, {.threads = 1});
  return result.tolerance.value_or(ToleranceResult{});
}

auto cam_with(const std::string& tolerance) {
  return parse_task<CamProblem>(
      "kind = \"cam\"\n[follower]\ntype = \"translating-roller\"\n[[motion]]\nlaw = \"cycloidal\"\n"
      "rise = 20\nover_deg = 60\n[[motion]]\nlaw = \"cycloidal\"\nrise = -20\nover_deg = 60\n"
      "[[motion]]\nlaw = \"dwell\"\nover_deg = 240\n"
      "[mechanism]\nbase_radius = 50\nroller_radius = 8\noffset = 0\n[tolerance]\n" +
      tolerance + "\n");
}

ToleranceResult of_cam(const std::string& tolerance) {
  const auto read = cam_with(tolerance);
  if (!read) {
    ADD_FAILURE() << read.error().front().message;
    return {};
  }
  const auto result = solve(*read, {.threads = 1});
  return result.designs.at(0).tolerance.value_or(ToleranceResult{});
}

const std::string kRocker =
    "type = \"four-bar\"\nfixed_pivots = [[0, 0], [110, 0]]\ncrank = 40\ncoupler = 120\n"
    "rocker = 80";

TEST(ToleranceLimits, OneSampleHasNoStandardDeviation) {
  for (const auto& result : {of_analysis(kRocker, "length = 0.1\nsamples = 1"),
                             of_cam("base_radius = 0.1\nsamples = 1")}) {
    ASSERT_EQ(result.assembled, 1u);
    for (const PositionFigures& at : result.quantities.at(0).positions) {
      EXPECT_TRUE(std::isfinite(at.mean));
      EXPECT_TRUE(std::isnan(at.sigma));
    }
  }
}

/// ± 0.99 of a crank of 1 are three sigma: a share of 0.0012 lies beyond the whole length.
TEST(ToleranceLimits, ASampleWithoutALengthIsNotAssembled) {
  const auto result =
      of_analysis("type = \"scotch-yoke\"\ncrank = 1", "length = 0.99\nsamples = 100000");
  const double lost = 1 - static_cast<double>(result.assembled) / 100000;
  const double share = 0.5 * std::erfc(3 / 0.99 / std::sqrt(2.0));
  EXPECT_NEAR(lost, share, 4 * std::sqrt(share / 100000));
  // Of which no quantile beyond is one: worse than any error, they are a share of 0.0012.
  for (const Quantile& quantile : result.quantities.at(0).quantiles) {
    EXPECT_EQ(std::isfinite(quantile.error), quantile.share < 1 - share) << quantile.share;
  }
}

TEST(ToleranceLimits, AWorstCaseThatOnePositionHasNotIsNone) {
  const auto result = of_analysis(kRocker, "length = 8\nsamples = 0");
  ASSERT_FALSE(result.refused);
  EXPECT_FALSE(result.notes.empty());
  for (const ToleranceFigures& figures : result.quantities) {
    EXPECT_FALSE(figures.exact) << figures.name;
    EXPECT_FALSE(figures.exact_everywhere) << figures.name;
  }
}

/// Of what is made about one half does not come to where the links are in line. Were that position
/// left out, all of it would seem good.
TEST(ToleranceLimits, ADesignWithAPointAtADeadPointHasNoFigures) {
  const auto read = parse_task<AnalysisProblem>(
      "kind = \"analysis\"\n[mechanism]\ntype = \"four-bar\"\nfixed_pivots = [[0, 0], [4, 0]]\n"
      "crank = 3\ncoupler = 2\nrocker = 2.5\ncoupler_point = [1, 0.5]\n[tolerance]\nlength = 0.01\n"
      "samples = 2000\n");
  ASSERT_TRUE(read);
  const double dead = std::acos((3 * 3 + 4 * 4 - 4.5 * 4.5) / (2 * 3 * 4));
  for (const double last : {dead, 0.95 * dead}) {
    const auto question = error_at_targets(read->mechanism, "P", {0.6 * dead, 0.8 * dead, last},
                                           {{4, 2}, {3, 3}, {3, 3}}, true);
    ASSERT_TRUE(question);
    const auto result = tolerance_figures(read->mechanism, *read->tolerances, {}, *question, {});
    EXPECT_EQ(result.refused.has_value(), last == dead);
    EXPECT_EQ(result.samples, last == dead ? 0 : 2000);
  }
}

bool cam_notes(const std::string& cam, std::string_view words) {
  const auto read = parse_task<CamProblem>("kind = \"cam\"\n" + cam);
  if (!read) {
    ADD_FAILURE() << read.error().front().message;
    return false;
  }
  const auto result = solve(*read, {.threads = 1});
  const auto& all = result.designs.at(0).tolerance.value().notes;
  return std::ranges::any_of(
      all, [&](const std::string& note) { return note.find(words) != std::string::npos; });
}

/// Some of the knives that are made would rest on a corner of a cam of constant velocity.
TEST(ToleranceLimits, CornersOfACamAreSaid) {
  const auto says = [](const std::string& law) {
    return cam_notes(fmt::format(
                         R"(
              follower = {{type = "translating-knife"}}
              motion = [{{law = "{0}", rise = 20, over_deg = 120}}, {{law = "dwell", over_deg = 60}},
                        {{law = "{0}", rise = -20, over_deg = 120}}, {{law = "dwell", over_deg = 60}}]
              mechanism = {{base_radius = 50, offset = 5}}
              tolerance = {{base_radius = 0.1, offset = 0.5, samples = 200}}
            )",
                         law),
                     "corner");
  };
  EXPECT_TRUE(says("constant-velocity"));
  EXPECT_FALSE(says("cycloidal"));
}

/// A knife edge at the foot of a steep harmonic rise stands in a hollow of radius 0.052.
TEST(ToleranceLimits, AFollowerLargerThanAHollowIsSaid) {
  const auto says = [](const std::string& raised) {
    return cam_notes(
        "follower = {type = \"translating-knife\"}\nmotion = [{law = \"harmonic\", over_deg = 20, "
        "rise "
        "= 0.5}, {law = \"dwell\", over_deg = 120}, {law = \"cycloidal\", over_deg = 100, rise = "
        "-0.5}, {law = \"dwell\", over_deg = 120}]\nmechanism = {base_radius = 1}\ntolerance = "
        "{distribution = \"uniform\", samples = 400, base_radius = {minus = 0, plus = " +
            raised + "}}\n",
        "rests on both flanks");
  };
  EXPECT_TRUE(says("0.06"));
  EXPECT_FALSE(says("0.03"));
}

/// Under a flat face the radius of curvature is r + s + s″, whose least value, with a cycloidal
/// rise of 0.5 in 60°, is r − 2.411: by the formula of the law, over a fine grid.
TEST(ToleranceLimits, AProfileThatIsUndercutWithinItsToleranceIsSaid) {
  const double span = kPi / 3;
  double least = kInfinity;
  for (int k = 0; k <= 100'000; ++k) {
    const double turn = kTurn * k / 100'000;
    least = std::min(least, 0.5 * (turn - std::sin(turn)) / kTurn +
                                0.5 * kTurn / (span * span) * std::sin(turn));
  }
  const auto says = [&](double reserve, double minus, std::string_view words) {
    return cam_notes(
        fmt::format(
            "follower = {{type = \"translating-flat\"}}\nmotion = [{{law = \"cycloidal\", "
            "over_deg = 60, rise = 0.5}}, {{law = \"dwell\", over_deg = 60}}, {{law = "
            "\"cycloidal\", over_deg = 60, rise = -0.5}}, {{law = \"dwell\", over_deg = "
            "180}}]\nmechanism = {{base_radius = {}}}\nconstraints = {{no_undercut = "
            "false}}\ntolerance = {{base_radius = {{plus = 0, minus = {}}}, samples = 0}}\n",
            reserve - least, minus),
        words);
  };
  EXPECT_TRUE(says(0.01, 0.0101, "undercut where the base radius is at its least"));
  EXPECT_FALSE(says(0.01, 0.0099, "undercut"));
  EXPECT_TRUE(says(-0.001, 0.001, "undercut as designed"));
}

/// The ram by the links' own geometry: the bar from the origin through the crank's pin.
TEST(ToleranceLimits, AShaperThatIsDesignedHasTolerances) {
  const auto read = parse_task<QuickReturnProblem>(
      "kind = \"quick-return\"\n[target]\ntime_ratio = 1.8587624499578357\n[mechanism]\n"
      "type = \"shaper\"\nstroke = 0.54545454545454545\nframe = 0.275\nrod = 0.15\n[tolerance]\n"
      "crank = 0.001\nsamples = 0\n");
  ASSERT_TRUE(read) << read.error().front().message;
  const auto result = solve(*read, {.threads = 1});
  ASSERT_FALSE(result.designs.empty());
  ASSERT_TRUE(result.designs[0].tolerance);
  const ToleranceResult& tolerance = *result.designs[0].tolerance;
  ASSERT_FALSE(tolerance.refused) << *tolerance.refused;
  const ToleranceFigures& ram = tolerance.quantities.at(0);
  const double angle = tolerance.drive.at(ram.worst) * std::acos(-1.0) / 180;
  const auto place = [&](double crank) {
    const double x = crank * std::cos(angle), y = 0.275 + crank * std::sin(angle);
    const double bar = 0.6 / std::hypot(x, y), below = 0.567217062849074 - bar * y;
    return bar * x - std::sqrt(0.15 * 0.15 - below * below);
  };
  const double slope = (place(0.125 + 1e-6) - place(0.125 - 1e-6)) / 2e-6;
  EXPECT_NEAR(std::abs(ram.contributions.at(0).sensitivity), std::abs(slope), 1e-6);
}

/// Boxes of two dyads' dimensions are not settled within the effort allowed.
TEST(ToleranceLimits, AWorstCaseThatWasNotFoundIsSaid) {
  const auto result = of_analysis(
      R"(
        type = "chain"
        pivot = [{name = "A", at = [0, 0.275]}, {name = "C", at = [0, 0]}]
        crank = {at = "A", pin = "B", length = 0.125}
        dyad = [{type = "RPR", joins = ["B", "C"], names = ["block", "bar"]},
                {type = "RRP", joins = ["D"], lengths = [0.15], new = "E", slide = {through = [0, 0.567], direction_deg = 180}}]
        point = [{name = "D", on = "bar", at = [0.6, 0]}]
      )",
      "length = 0.01\nsamples = 0");
  std::string missing;
  for (const ToleranceFigures& figures : result.quantities) {
    if (!figures.exact) missing += (missing.empty() ? "" : ", ") + figures.name;
  }
  ASSERT_FALSE(missing.empty());
  EXPECT_TRUE(std::ranges::any_of(result.notes, [&](const std::string& note) {
    return note.starts_with(missing + ": the exact worst case was not found");
  }));
}

TEST(ToleranceLimits, NotesSayWhereFiguresMeanLittle) {
  const auto says = [](const std::string& tolerance, const std::string& word) {
    const auto result = of_analysis(kRocker, tolerance);
    return std::ranges::any_of(result.notes, [&](const std::string& note) {
      return note.find(word) != std::string::npos;
    });
  };
  EXPECT_TRUE(says("length = 0.1\nsamples = 1", "1 sample is too few for the quantile of 50 %"));
  EXPECT_TRUE(
      says("length = 0.1\nsamples = 99", "99 samples are too few for the quantile of 99 %"));
  EXPECT_TRUE(says("length = 0.1\nsamples = 999", "quantile of 99.9 %"));
  EXPECT_FALSE(says("length = 0.1\nsamples = 1000", "too few"));
  EXPECT_FALSE(says("length = 0.1\nsamples = 0", "too few"));
  EXPECT_TRUE(says("samples = 0\nclearance = {B = 40}", "clearance of B"));
  EXPECT_FALSE(says("samples = 0\nclearance = {B = 39}", "clearance of B"));
  const std::string limit = "length = 0.1\nsamples = 0\nallocate = {limit_deg = ";
  EXPECT_TRUE(
      says(limit + "1e6}", "tolerance.allocate gives frame, crank, coupler, rocker are as"));
  EXPECT_FALSE(says(limit + "1}", "are as large as"));
}

TEST(ToleranceLimits, ACamOfNoRadiusIsRefusedAndOneUndercutHasNoWorstCase) {
  const auto refused = cam_with("base_radius = 50\nsamples = 0");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().front().message,
            "tolerance.base_radius cannot be met: base_radius is 50 long, of which a tolerance of "
            "-50 leaves nothing; expected less");
  const auto undercut = of_cam("base_radius = { plus = 0, minus = 49 }\nsamples = 0");
  ASSERT_FALSE(undercut.refused);
  EXPECT_FALSE(undercut.quantities.at(0).exact_everywhere);
}

}  // namespace
}  // namespace cognate::problems::tolerance_limits_test
