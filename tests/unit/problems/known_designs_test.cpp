/// Searches that begin with designs that are known: what such a design already reaches is reached
/// without any start of their own.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "problems/linkage/result.hpp"
#include "problems/read.hpp"

namespace cognate::problems::known_designs_test {
namespace {

/// Solves, and solves again from the best design alone; the errors must agree.
template <class AnyProblem>
void expect_come_back(const std::string& text) {
  auto parsed = parse_task(text);
  ASSERT_TRUE(parsed) << text;
  auto problem = std::get<AnyProblem>(*parsed);
  Run run;
  const Result first = solve(problem, run);
  ASSERT_EQ(first.status, Status::solved) << text;
  run.known = {first.designs.front()};
  problem.solve.starts = 0;
  const Result again = solve(problem, run);
  ASSERT_EQ(again.status, Status::solved) << text;
  const double error = first.designs.front().error.rms;
  ASSERT_GT(error, 1e-6);
  EXPECT_NEAR(again.designs.front().error.rms, error, 1e-7 * error);
  run.known.clear();
  EXPECT_TRUE(solve(problem, run).designs.empty()) << "there is no start at all";
}

/// A long list of points of an oval, and crank angles that go with them.
std::string oval(int count, bool timed, double sense) {
  std::string points, angles;
  for (int i = 0; i < count; ++i) {
    const double t = 5.5 * i / count;
    points += "[" + std::to_string(3 + 2 * std::cos(t)) + ", " +
              std::to_string(1 + std::sin(t) + 0.3 * std::cos(2 * t)) + "], ";
    angles += std::to_string(sense * t / 0.0174532925) + ", ";
  }
  std::string text = "kind = \"path-generation\"\n[target]\npoints = [" + points + "]\n";
  if (timed) text += "timing = \"prescribed\"\ncrank_deg = [" + angles + "]\n";
  return text +
         "[bounds]\nlength = [0.2, 20]\n[constraints]\nclass = \"crank-rocker\"\n"
         "[solve]\ndesigns = 1\n";
}

TEST(KnownDesignsTest, OfPaths) {
  expect_come_back<PathProblem>(oval(12, false, 1));
  expect_come_back<PathProblem>(oval(12, true, 1));
  expect_come_back<PathProblem>(oval(12, true, -1));
}

/// A design whose crank turns the other way is no start for increments that count clockwise.
TEST(KnownDesignsTest, KeepToTheSenseAskedFor) {
  auto parsed = parse_task(oval(12, true, 1));
  ASSERT_TRUE(parsed);
  auto problem = std::get<PathProblem>(*parsed);
  problem.crank_sense = CrankSense::ccw;
  problems::Run run;
  const Result ccw = solve(problem, run);
  ASSERT_EQ(ccw.status, Status::solved);
  run.known = {ccw.designs.front()};
  problem.crank_sense = CrankSense::cw;
  problem.solve.starts = 0;
  problem.solve.designs = 6;
  const Result turned = solve(problem, run);
  EXPECT_FALSE(turned.designs.empty());
  for (const Design& design : turned.designs) {
    for (std::size_t i = 1; i < design.crank_angles.size(); ++i) {
      EXPECT_LT(std::remainder(design.crank_angles[i] - design.crank_angles[i - 1], 6.283185307),
                0);
    }
  }
}

TEST(KnownDesignsTest, OfLongPaths) {
  expect_come_back<PathProblem>(oval(90, false, 1));
  expect_come_back<PathProblem>(oval(90, true, 1));
}

TEST(KnownDesignsTest, OfFunctions) {
  expect_come_back<FunctionProblem>(
      "kind = \"function-generation\"\n[target]\nfunction = \"log10(x)\"\ndomain = [1, 10]\n"
      "input_range_deg = 90\noutput_range_deg = 90\n[solve]\ndesigns = 1\n");
}

TEST(KnownDesignsTest, OfMotions) {
  expect_come_back<MotionProblem>(R"(kind = "motion-generation"
[target]
poses = [[-1, -1, 90], [-1.2, -0.5, 77], [-1.4, 0.3, 55], [-1.2, 1.3, 30], [-0.5, 1.9, 10],
         [0.3, 1.6, 10], [1.1, 0.4, 55], [2, 0, 90]]
method = "least-squares"
[mechanism]
dyads = ["RR"]
[solve]
designs = 1
)");
}

/// A body in its link is no part of a mechanism: it is turned to the poses again.
/// The same of greatest errors, which a search that goes on from a design may make less.
template <class AnyProblem>
void expect_no_worse(const std::string& text) {
  const auto parsed = parse_task(text);
  ASSERT_TRUE(parsed) << text;
  auto problem = std::get<AnyProblem>(*parsed);
  Run run;
  const Result first = solve(problem, run);
  ASSERT_EQ(first.status, Status::solved) << text;
  run.known = {first.designs.front()};
  problem.solve.starts = 0;
  const Result again = solve(problem, run);
  ASSERT_EQ(again.status, Status::solved) << text;
  const double error = first.designs.front().error.max;
  constexpr double kRounding = 1e-8;  // of the margins that a search leaves
  EXPECT_LE(again.designs.front().error.max, error * (1 + 1e-6) + kRounding);
  EXPECT_GE(again.designs.front().error.max, 0.5 * error);
  run.known.clear();
  EXPECT_TRUE(solve(problem, run).designs.empty()) << "there is no start at all";
}

TEST(KnownDesignsTest, OfFunctionsOfChains) {
  expect_no_worse<ChainFunctionProblem>(
      "kind = 'function-generation'\n[target]\nfunction = 'log10(x)'\ndomain = [1, 10]\n"
      "input_range_deg = 90\noutput_range_deg = 90\nobjective = 'minimax'\n[mechanism]\n"
      "type = 'watt-2'\n[bounds]\nlength = [0.4, 5]\n[constraints]\n"
      "transmission_angle_deg = [40, 140]\n[solve]\nstarts = 64\ndesigns = 1\n");
}

TEST(KnownDesignsTest, OfDwells) {
  expect_no_worse<DwellProblem>(
      "kind = 'function-generation'\n[target]\ndwell = [{ over_deg = 90 }]\nswing_deg_min = 40\n"
      "[mechanism]\ntype = 'stephenson-3'\n[constraints]\ntransmission_angle_deg = [30, 150]\n"
      "[solve]\nstarts = 64\ndesigns = 1\n");
}

TEST(KnownDesignsTest, OfLegs) {
  expect_no_worse<LegProblem>(
      "kind = 'leg'\n[target]\nduty = 0.55\nstride = 1\nheight_min = 0.4\n[mechanism]\n"
      "type = 'klann'\n[constraints]\ntransmission_angle_deg = [25, 155]\n"
      "[solve]\nstarts = 32\ndesigns = 1\n");
}

TEST(KnownDesignsTest, OfMotionsOfChains) {
  for (const int count : {14, 70}) {
    for (const bool timed : {false, true}) {
      std::string poses, angles;
      for (int i = 0; i < count; ++i) {
        const double t = 6.283185307 * i / count;
        poses += "[" + std::to_string(3 + 2 * std::cos(t)) + ", " +
                 std::to_string(1 + std::sin(t) + 0.3 * std::cos(2 * t)) + ", " +
                 std::to_string(150 + 40 * std::sin(t)) + "], ";
        angles += std::to_string(-360.0 * i / count) + ", ";
      }
      expect_come_back<ChainMotionProblem>(
          "kind = \"motion-generation\"\n[target]\nclosed = true\nposes = [" + poses + "]\n" +
          (timed ? "crank_deg = [" + angles + "]\n" : "") +
          "[mechanism]\ntype = \"watt-1\"\n[bounds]\nlength = [0.2, 20]\n[constraints]\n"
          "transmission_angle_deg = [20, 160]\n[solve]\ndesigns = 1\nstarts = 512\n");
    }
  }
}

}  // namespace
}  // namespace cognate::problems::known_designs_test
