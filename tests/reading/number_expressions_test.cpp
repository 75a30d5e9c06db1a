// Numbers written as expressions, and speeds in turns a minute, wherever a number stands.

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <variant>

#include "analysis/numbers/constants.hpp"
#include "problems/evaluation/problem.hpp"
#include "problems/read.hpp"
#include "tests/reading/fault_cases.hpp"

namespace cognate::problems::number_expressions_test {
namespace {

std::string rocker(const std::string& crank, const std::string& drive) {
  return "kind = \"analysis\"\n[mechanism]\ntype = \"four-bar\"\ncrank = " + crank +
         "\ncoupler = \"7/2\"\nrocker = 3\nfixed_pivots = [[0, 0], [\"2*sqrt(4)\", "
         "0]]\ncoupler_point = [\"1/3\", 1]\n"
         "[drive]\nstart_deg = \"-360/7\"\nsteps = \"2*180\"\n" +
         drive;
}

AnalysisProblem analysis(const std::string& text) {
  const auto read = parse_task<AnalysisProblem>(text);
  EXPECT_TRUE(read) << (read ? "" : read.error().front().message);
  return read.value_or(AnalysisProblem{});
}

TEST(NumberExpressions, StandForTheirNumbers) {
  const AnalysisProblem written = analysis(rocker("\"1 + 0.25\"", "speed = \"170*2*pi/60\"\n"));
  const AnalysisProblem plain = analysis(
      "kind = \"analysis\"\n[mechanism]\ntype = \"four-bar\"\ncrank = 1.25\ncoupler = 3.5\n"
      "rocker = 3\nfixed_pivots = [[0, 0], [4, 0]]\ncoupler_point = [0.33333333333333333, 1]\n"
      "[drive]\nstart_deg = -51.42857142857143\nsteps = 360\nspeed = 17.802358370342162\n");
  EXPECT_EQ(written.drive.start, plain.drive.start);
  EXPECT_EQ(written.drive.steps, plain.drive.steps);
  EXPECT_EQ(written.drive.rate.speed, plain.drive.rate.speed);
  const auto& [a, b] = std::pair(std::get<FourBar>(written.mechanism.description),
                                 std::get<FourBar>(plain.mechanism.description));
  EXPECT_EQ(a.crank, b.crank);
  EXPECT_EQ(a.coupler, b.coupler);
  EXPECT_EQ(a.pivot_d.x - a.pivot_a.x, b.pivot_d.x - b.pivot_a.x);
  EXPECT_EQ(a.coupler_point->x, b.coupler_point->x);
}

TEST(NumberExpressions, SpeedsMayBeGivenInTurnsAMinute) {
  const double speed = analysis(rocker("1", "speed_rpm = 170\n")).drive.rate.speed;
  EXPECT_DOUBLE_EQ(speed, 170 * 2 * kPi / 60);
}

class NumberExpressionFaults : public ::testing::TestWithParam<FaultCase> {};

TEST_P(NumberExpressionFaults, AreFound) {
  expect_faults(GetParam());
}

INSTANTIATE_TEST_SUITE_P(
    Numbers, NumberExpressionFaults,
    ::testing::Values(
        FaultCase{
            "Unfinished", rocker("\"2*\"", ""), {{4, 9, "is \"2*\", which is no expression"}}},
        FaultCase{"Unknown", rocker("\"2*pie\"", ""), {{4, 9, "cannot be read from \"pie\" on"}}},
        FaultCase{"OutOfRange", rocker("\"1 - 1\"", ""), {{4, 9, "is 0; expected a length"}}},
        FaultCase{"NoNumber", rocker("\"0/0\"", ""), {{4, 9, "nan; expected a length"}}},
        FaultCase{"Both", rocker("1", "speed = 1\nspeed_rpm = 10\n"), {{13, 13, "one of them"}}},
        FaultCase{"NotWhole",
                  "kind = \"analysis\"\n[mechanism]\ntype = \"four-bar\"\ncrank = 1\n"
                  "coupler = 3\nrocker = 3\nfixed_pivots = [[0, 0], [3, 0]]\n[drive]\nsteps = "
                  "\"360/7\"\n",
                  {{9, 9, "is 51.42"}}}),
    [](const auto& info) { return name_of_case(info); });

}  // namespace
}  // namespace cognate::problems::number_expressions_test
