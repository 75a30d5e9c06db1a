/// `spacing = "equal-peaks"` from its file to designs, against Chebyshev's spacing.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "analysis/numbers/constants.hpp"
#include "problems/linkage/result.hpp"
#include "problems/read.hpp"
#include "tests/reading/fault_cases.hpp"

namespace cognate::problems::function_respacing_test {
namespace {

// The first line that is added is line 7, in [target].
std::string file(const std::string& lines, const std::string& function = "log10(x)",
                 const std::string& ranges = "60\noutput_range_deg = 90") {
  return "kind = \"function-generation\"\n[target]\nfunction = \"" + function +
         "\"\ndomain = [1, 2]\ninput_range_deg = " + ranges + "\n" + lines;
}

Result solved(const std::string& text) {
  const auto problem = parse_task(text);
  EXPECT_TRUE(problem) << (problem ? "" : problem.error()[0].message);
  return problem ? solve(std::get<FunctionProblem>(*problem), {}) : Result{};
}

const std::string kLevel = "spacing = \"equal-peaks\"\n";
const std::string kGiven = "[mechanism]\ninput_start_deg = 86\noutput_start_deg = 23.5\n";

TEST(FunctionRespacing, LowersTheGreatestErrorOfThePublishedExample) {
  const Result plain = solved(file("precision_points = 3\n" + kGiven));
  const Result level = solved(file("precision_points = 3\n" + kLevel + kGiven));
  ASSERT_EQ(plain.designs.size(), 1U);
  ASSERT_EQ(level.designs.size(), 1U);
  EXPECT_EQ(level.status, Status::solved);
  EXPECT_NEAR(plain.designs[0].error.max / kDegree, 0.5829139524285558, 1e-9);
  EXPECT_LT(level.designs[0].error.max, 0.9 * plain.designs[0].error.max);
  EXPECT_LE(*level.designs[0].metrics.precision_residual, 1e-12);
  EXPECT_EQ(level.designs[0].crank_angles.size(), 3U);
  EXPECT_NE(level.notes.back().find("4 peaks"), std::string::npos) << level.notes.back();
}

TEST(FunctionRespacing, ReachesTheBestKnownWithFreeStarts) {
  const Result level =
      solved(file("precision_points = 5\n" + kLevel, "1/x", "90\noutput_range_deg = 90"));
  ASSERT_FALSE(level.designs.empty());
  EXPECT_LE(level.designs[0].error.max / kDegree, 0.012815564605462178);
  EXPECT_GE(level.designs[0].error.max / kDegree, 0.0127);
}

TEST(FunctionRespacing, KeepsTheFrameGiven) {
  const Result level = solved(file("precision_points = 3\n" + kLevel + kGiven + "frame = 7\n"));
  ASSERT_EQ(level.designs.size(), 1U);
  EXPECT_NEAR(lengths(four_bar(level.designs[0])).frame, 7, 1e-14);
  EXPECT_EQ(level.status, Status::solved);
}

TEST(FunctionRespacing, Faults) {
  const std::vector<FaultCase> cases = {
      {"Family", file("precision_points = 3\n" + kLevel), {{8, 11, "precision_points = 5"}}},
      {"BesideAt",
       file("at = [1.1, 1.5, 1.9]\n" + kLevel + kGiven),
       {{8, 11, "is given beside at"}}},
      {"NotExact", file(kLevel), {{7, 11, "is for exact synthesis"}}},
      {"Misspelt",
       file("precision_points = 3\nspacing = \"equal-peeks\"\n" + kGiven),
       {{8, 11, "\"equal-peaks\""}}}};
  for (const FaultCase& one : cases) {
    SCOPED_TRACE(one.name);
    expect_faults(one);
  }
}

}  // namespace
}  // namespace cognate::problems::function_respacing_test
