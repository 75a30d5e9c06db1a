/// Paths of chains from their files: what is read, every fault of a file, and the echo.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "problems/read.hpp"
#include "problems/toml/table_writer.hpp"
#include "tests/reading/fault_cases.hpp"
#include "tests/support/folders.hpp"

namespace cognate::problems::chain_problem_test {
namespace {

/// A file with `more` after a closed target of four points; the first line of it is line 4.
std::string file(const std::string& more) {
  return "kind = \"path-generation\"\n[target]\npoints = [[0, 0], [2, 0], [1, 1], [0, 0]]\n" + more;
}

/// A chain; the first line of `more` is line 6 in [target].
std::string chain(const std::string& parts, const std::string& target = "") {
  return file(target + "[mechanism]\ntype = \"chain\"\n" + parts);
}

const std::string kPivots = "[[pivot]]\nname = \"A\"\n[[pivot]]\nname = \"D\"\n";
const std::string kCrank = "[crank]\nat = \"A\"\npin = \"B\"\n";
const std::string kDyad = "[[dyad]]\njoins = [\"B\", \"D\"]\nnew = \"C\"\n";
const std::string kPoint = "[[point]]\nname = \"P\"\non = [\"B\", \"C\"]\n";

ChainPathProblem read(const std::string& text) {
  const auto task = parse_task<ChainPathProblem>(text);
  if (!task) {
    for (const Fault& fault : task.error()) ADD_FAILURE() << fault.line << ": " << fault.message;
    return {};
  }
  return *task;
}

TEST(ChainProblem, ATopologyByItsWord) {
  const auto problem =
      read(file("[mechanism]\ntype = \"six-bar\"\n[bounds]\nlength = [1, 5]\n"
                "C = [[2, 9], [0, 3]]\npivots = [[-1, -2], [3, 4]]\n"
                "[constraints]\ntransmission_angle_deg = [30, 150]\n"));
  ASSERT_EQ(problem.topologies.size(), 3U);
  EXPECT_TRUE(problem.closed);
  EXPECT_EQ(problem.points.size(), 3U) << "the last repeats the first";
  EXPECT_EQ(problem.constraints.over, LimitSpan::turn);
  EXPECT_NEAR(problem.constraints.transmission_angle.min, 0.5235987755982988, 1e-15);
  const auto& joint = problem.topologies[1].lines[3];
  EXPECT_EQ(joint.name, "C");
  EXPECT_EQ(joint.bounds[0].min, 2);
  EXPECT_EQ(joint.bounds[0].max, 5);
  EXPECT_EQ(joint.bounds[1].max, 3);
  EXPECT_EQ(problem.topologies[0].lines[0].bounds[1].min, -2);
}

TEST(ChainProblem, AChainPointByPoint) {
  const auto problem =
      read(chain("[[pivot]]\nname = \"A\"\nat = [0, \"free\"]\n"
                 "[[pivot]]\nname = \"D\"\nat = [3, 4]\n" +
                     kCrank + "length = 1\n" + kDyad +
                     "lengths = [4, \"free\"]\nassembly = \"crossed\"\n" + kPoint,
                 "closed = false\n"));
  EXPECT_FALSE(problem.closed);
  EXPECT_EQ(problem.points.size(), 4U);
  ASSERT_EQ(problem.topologies.size(), 1U);
  const Topology& topology = problem.topologies[0];
  ASSERT_EQ(topology.lines.size(), 5U);
  EXPECT_EQ(topology.lines[0].given[0], 0.0);
  EXPECT_FALSE(topology.lines[0].given[1]);
  EXPECT_EQ(topology.lines[2].given[0], 1.0);
  EXPECT_EQ(topology.lines[3].line.first, 2);
  EXPECT_EQ(topology.lines[3].line.second, 1);
  EXPECT_EQ(topology.lines[3].assembly, Assembly::crossed);
  EXPECT_FALSE(topology.lines[3].given[1]);
  EXPECT_EQ(topology.lines[std::size_t(topology.trace)].name, "P");
}

TEST(ChainProblem, TimingCountsInDifferences) {
  const auto problem =
      read(file("crank_deg = [10, 100, 200, 370]\n[mechanism]\ntype = \"watt-1\"\n"));
  EXPECT_EQ(problem.crank_angles.size(), 3U);
}

TEST(ChainProblem, FourBarsStayOfTheirOwnKind) {
  const auto task = parse_task(file("[mechanism]\ntype = \"four-bar\"\n"));
  ASSERT_TRUE(task);
  EXPECT_TRUE(std::holds_alternative<PathProblem>(*task));
  const auto wrong = parse_task<PathProblem>(file("[mechanism]\ntype = \"watt-1\"\n"));
  ASSERT_FALSE(wrong);
  EXPECT_NE(wrong.error()[0].message.find("of another mechanism"), std::string::npos);
}

TEST(ChainProblem, WhatIsWrittenIsRead) {
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(kLibraryFolder) + "/chain")) {
    const auto problem = read_task<ChainPathProblem>(entry.path());
    ASSERT_TRUE(problem) << entry.path();
    const auto back = reading::read_back(*problem);
    ASSERT_TRUE(back) << entry.path() << ": " << back.error()[0];
    ASSERT_EQ(back->topologies.size(), problem->topologies.size());
    for (std::size_t i = 0; i < back->topologies.size(); ++i) {
      const Topology &a = back->topologies[i], &b = problem->topologies[i];
      EXPECT_EQ(a.trace, b.trace);
      ASSERT_EQ(a.lines.size(), b.lines.size());
      for (std::size_t k = 0; k < a.lines.size(); ++k) {
        EXPECT_EQ(a.lines[k].name, b.lines[k].name);
        EXPECT_EQ(a.lines[k].given, b.lines[k].given);
        EXPECT_EQ(a.lines[k].bounds[0].max, b.lines[k].bounds[0].max);
        EXPECT_EQ(a.lines[k].assembly, b.lines[k].assembly);
      }
    }
    EXPECT_EQ(back->crank_angles.size(), problem->crank_angles.size());
  }
}

class ChainFaults : public ::testing::TestWithParam<FaultCase> {};

TEST_P(ChainFaults, AreFoundInTheirPlace) {
  expect_faults(GetParam());
}

const FaultCase kFaults[] = {
    {"TypeMisspelt", file("[mechanism]\ntype = \"wat-1\"\n"), {{5, 8, "perhaps for \"watt-1\""}}},
    {"NeitherRrrNorRrp",
     chain(kPivots + kCrank + "[[dyad]]\ntype = \"RPR\"\njoins = [\"B\", \"D\"]\nnew = \"C\"\n" +
           kPoint),
     {{14, 8, "a chain is designed of RRR and RRP dyads"}}},
    {"UnknownJoin",
     chain(kPivots + kCrank + "[[dyad]]\njoins = [\"B\", \"Z\"]\nnew = \"C\"\n" + kPoint),
     {{14, 15, "has \"Z\", which is no point of the chain"}}},
    {"RigidDyad",
     chain(kPivots + kCrank + kDyad + "[[dyad]]\njoins = [\"B\", \"C\"]\nnew = \"E\"\n"),
     {{17, 15, "two points of one body"}}},
    {"PointOnNoLink",
     chain(kPivots + kCrank + kDyad + "[[point]]\nname = \"P\"\non = [\"A\", \"C\"]\n"),
     {{18, 12, "which no link has both"}}},
    {"TraceOnCrank",
     chain(kPivots + kCrank + kDyad, "point = \"B\"\n"),
     {{4, 9, "a point of the crank"}}},
    {"WithoutInfluence",
     chain(kPivots + kCrank + kDyad + "[[pivot]]\nname = \"G\"\n"),
     {{16, 1, "\"G\" has no influence"}}},
    {"UnknownName",
     file("[mechanism]\ntype = \"watt-1\"\n[[pivot]]\nname = \"G\"\nat = [0, 0]\n"),
     {{7, 8, "is no pivot of this mechanism.type"}}},
    {"OutsideBounds",
     file("[mechanism]\ntype = \"watt-1\"\n[crank]\nlength = 9\n[bounds]\nlength = [1, 5]\n"),
     {{7, 10, "outside its bounds"}}},
    {"LimitOfFourBars",
     file("[mechanism]\ntype = \"watt-1\"\n[constraints]\nclass = \"crank-rocker\"\n"),
     {{7, 9, "is a limit of four-bars"}}},
    {"NoMotionKeepsTo",
     file("[mechanism]\ntype = \"watt-1\"\n[constraints]\ntransmission_angle_deg = [95, 150]\n"),
     {{7, 26, "no dyad satisfies"}}},
    {"SolverOfFourBars",
     file("[mechanism]\ntype = \"watt-1\"\n[solve]\nsolver = \"slsqp\"\n"),
     {{7, 10, "is for four-bars alone"}}},
    {"ObjectiveOfFourBars",
     file("[mechanism]\ntype = \"watt-1\"\n[solve]\nobjectives = [\"error\", \"link_ratio\"]\n"),
     {{7, 24, "allowed of chains are \"error\", \"transmission_angle\", \"size\", \"links\""}}},
    {"ObjectivesWithoutError",
     file("[mechanism]\ntype = \"watt-1\"\n[solve]\nobjectives = [\"size\", \"links\"]\n"),
     {{7, 14, "expected \"error\" and one other"}}},
    {"LinksOfOneTopology",
     file("[mechanism]\ntype = \"watt-1\"\n[solve]\nobjectives = [\"error\", \"links\"]\n"),
     {{7, 14, "every chain of type = \"watt-1\" has 6 links"}}},
    {"LinksWithDesigns",
     file("[mechanism]\ntype = \"any\"\n[solve]\nobjectives = [\"error\", \"links\"]\n"
          "designs = 3\n"),
     {{8, 11, "gives one design for each number of links"}}},
    {"FrontOfOneDesign",
     file("[mechanism]\ntype = \"watt-1\"\n[solve]\nobjectives = [\"size\", \"error\"]\n"
          "designs = 1\n"),
     {{8, 11, "a front has two ends"}}},
    {"FrontOfARobustDesign",
     file("[mechanism]\ntype = \"watt-1\"\n[solve]\nobjectives = [\"error\", \"size\"]\n"
          "robust = 0.95\n[tolerance]\nlength = 0.1\n"),
     {{7, 14, "is given with robust"}}},
    {"AnglesTooFew",
     file("crank_deg = [1, 2]\n[mechanism]\ntype = \"watt-1\"\n"),
     {{4, 13, "has 2 angles for 4 points"}}},
    {"FreeTimingWithAngles",
     file("timing = \"free\"\ncrank_deg = [1, 2, 3, 361]\n[mechanism]\ntype = \"watt-1\"\n"),
     {{5, 13, "is given with free timing"}}},
    {"PointOfATopology",
     file("point = \"F\"\n[mechanism]\ntype = \"watt-1\"\n"),
     {{4, 9, "whose point P is traced"}}},
    {"NoParts",
     chain(""),
     {{4, 1, "pivot is missing"}, {4, 1, "crank is missing"}, {4, 1, "dyad is missing"}}},
};

INSTANTIATE_TEST_SUITE_P(Files, ChainFaults, ::testing::ValuesIn(kFaults), name_of_case);

}  // namespace
}  // namespace cognate::problems::chain_problem_test
