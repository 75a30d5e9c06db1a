/// Exact function generation by slider-cranks from a problem file to its designs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "analysis/linkage/motion.hpp"
#include "analysis/linkage/slider_crank_mobility.hpp"
#include "analysis/numbers/constants.hpp"
#include "tests/support/exact_functions.hpp"

namespace cognate::problems::exact_slider_crank_test {
namespace {

using namespace exact_functions;

TEST(ExactSliderCrank, OfThreePlaces) {
  const Result result = solve(from_library("slider-crank-pairs.toml"), {});
  ASSERT_EQ(result.status, Status::solved);
  ASSERT_EQ(result.designs.size(), 1U);
  const Design& design = result.designs[0];
  const auto& m = std::get<SliderCrank>(design.mechanism.description);
  EXPECT_NEAR(m.crank, 40, 1e-6);
  EXPECT_NEAR(m.coupler, 120, 1e-6);
  EXPECT_NEAR(m.offset, 15, 1e-6);
  EXPECT_EQ(design.origin, "exact:slider-crank-3");
  EXPECT_LT(design.error.max, 1e-11);
}

// The slider goes the way that output_range says, in both senses, and through all five points.
TEST(ExactSliderCrank, OfFivePointsInBothSenses) {
  for (const double range : {100.0, -100.0}) {
    FunctionProblem problem = from_library("slider-crank-square.toml");
    std::get<FunctionOfX>(problem.target).output_range = range;
    const Result result = solve(problem, {});
    ASSERT_EQ(result.status, Status::solved);
    ASSERT_EQ(result.designs.size(), 3U);
    for (const Design& design : result.designs) {
      const auto& m = std::get<SliderCrank>(design.mechanism.description);
      const double start = *design.metrics.input_start;
      const double travel = *displacement(m, start + 60 * kDegree) - *displacement(m, start);
      EXPECT_NEAR(travel, range, 0.1);
      EXPECT_LT(design.error.max, 0.05);
    }
  }
}

TEST(ExactSliderCrank, Families) {
  const std::string head =
      "kind = \"function-generation\"\n[target]\nfunction = \"x^2\"\ndomain = [0, 1]\n"
      "input_range_deg = 60\noutput_range = 100\n";
  const Result four = solve(
      parsed(head + "precision_points = 4\n[mechanism]\ntype = \"slider-crank\"\n[constraints]\n"
                    "transmission_angle_deg = [40, 140]\n"),
      {});
  ASSERT_EQ(four.status, Status::solved);
  EXPECT_EQ(four.designs.front().origin, "exact:slider-crank-4");
  ASSERT_FALSE(four.families.empty());
  const Result three = solve(
      parsed(head + "precision_points = 3\n[mechanism]\ntype = \"slider-crank\"\n[constraints]\n"
                    "transmission_angle_deg = [40, 140]\nlink_ratio_max = 6\n"),
      {});
  ASSERT_EQ(three.status, Status::solved);
  EXPECT_LT(three.designs.front().error.max, 1);
}

// Every design of a given offset meets the points as the kernel moves it; a bound on the offset is
// kept by the best of a family, or named where no member keeps it.
TEST(ExactSliderCrank, WithItsOffsetGiven) {
  const std::string head =
      "kind = \"function-generation\"\n[target]\nfunction = \"x^2\"\ndomain = [0, 1]\n"
      "input_range_deg = 60\noutput_range = 100\n";
  int tested = 0;
  for (const double offset : {0.0, 20.0, -35.0}) {
    for (const std::string more : {"precision_points = 4\n[mechanism]\n",
                                   "precision_points = 3\n[mechanism]\ninput_start_deg = 200\n",
                                   "precision_points = 3\n[mechanism]\noutput_start = 60\n"}) {
      const Result result = solve(
          parsed(head + more + "type = \"slider-crank\"\noffset = " + std::to_string(offset)), {});
      for (const Design& design : result.designs) {
        const auto& m = std::get<SliderCrank>(design.mechanism.description);
        EXPECT_EQ(m.offset, offset);
        EXPECT_LT(*design.metrics.precision_residual, 1e-11);
        const auto check =
            std::ranges::find(design.constraints, "mechanism.offset", &ConstraintCheck::name);
        ASSERT_NE(check, design.constraints.end());
        EXPECT_TRUE(check->satisfied);
        if (!design.metrics.defects.empty()) continue;
        // s over the interval of Chebyshev's points goes as the square.
        const double start = *design.metrics.input_start;
        const std::size_t count = design.crank_angles.size();
        ASSERT_GE(count, 3U);
        std::vector<double> s;
        for (std::size_t i = 0; i < count; ++i) {
          const double x =
              0.5 - 0.5 * std::cos((2.0 * double(i) + 1) * kPi / (2.0 * double(count)));
          s.push_back(*displacement(m, start + 60 * kDegree * x) - 100 * x * x);
        }
        for (const double each : s) EXPECT_NEAR(each, s[0], 1e-7 * (m.crank + m.coupler));
        ++tested;
      }
    }
  }
  EXPECT_GE(tested, 6);
}

TEST(ExactSliderCrank, KeepsBoundsOfItsOffset) {
  const std::string head =
      "kind = \"function-generation\"\n[target]\nfunction = \"x^2\"\ndomain = [0, 1]\n"
      "input_range_deg = 60\noutput_range = 100\nprecision_points = 4\n[mechanism]\ntype = "
      "\"slider-crank\"\n";
  const Result kept = solve(parsed(head + "[bounds]\noffset = [-5, 5]\n"), {});
  ASSERT_FALSE(kept.designs.empty());
  EXPECT_EQ(kept.status, Status::solved);
  const auto& m = std::get<SliderCrank>(kept.designs[0].mechanism.description);
  EXPECT_LE(std::abs(m.offset), 5 * (1 + 1e-6));
  const Result five = solve(
      parsed("kind = \"function-generation\"\n[target]\nfunction = \"x^2\"\ndomain = [0, 1]\n"
             "input_range_deg = 60\noutput_range = 100\nprecision_points = 5\n[mechanism]\ntype = "
             "\"slider-crank\"\n[bounds]\noffset = [1e6, 2e6]\n"),
      {});
  EXPECT_EQ(five.status, Status::infeasible);
  // Three points and the offset leave one number free.
  const Result family = solve(
      parsed("kind = \"function-generation\"\n[target]\nfunction = \"x^2\"\ndomain = [0, 1]\n"
             "input_range_deg = 60\noutput_range = 100\nprecision_points = 3\n[mechanism]\ntype = "
             "\"slider-crank\"\noffset = 10\n"),
      {});
  ASSERT_FALSE(family.designs.empty());
  EXPECT_FALSE(family.families.empty());
  for (const Design& design : family.designs) {
    EXPECT_EQ(std::get<SliderCrank>(design.mechanism.description).offset, 10);
  }
}

TEST(ExactSliderCrank, LinksAtTheLimitComeLast) {
  const Result result = solve(from_library("slider-crank-square.toml"), {});
  ASSERT_EQ(result.designs.size(), 3U);
  const auto ratio = [&](std::size_t i) {
    const auto& m = std::get<SliderCrank>(result.designs[i].mechanism.description);
    return std::max(m.crank, m.coupler) / std::min(m.crank, m.coupler);
  };
  EXPECT_LT(ratio(0), 10);
  EXPECT_LT(ratio(1), 10);
  EXPECT_GT(ratio(2), 1000);
  EXPECT_TRUE(says(result, "Design 3: the longest link"));
}

}  // namespace
}  // namespace cognate::problems::exact_slider_crank_test
