/// Faulty `[tolerance]` tables, each with one message that says what is expected, and what they may
/// name of chains that are yet to be found.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "problems/kinds.hpp"
#include "tests/reading/fault_cases.hpp"

namespace cognate::problems::tolerance_faults_test {
namespace {

// A four-bar with a table of tolerances: `lines` begin at line 9.
std::string rocker(const std::string& lines) {
  return "kind = \"analysis\"\n[mechanism]\ntype = \"four-bar\"\n"
         "fixed_pivots = [[0, 0], [110, 0]]\ncrank = 40\ncoupler = 120\nrocker = "
         "80\n[tolerance]\n" +
         lines;
}

// A path of a chain with a table of tolerances: `lines` begin at line 11.
std::string path(const std::string& type, const std::string& lines) {
  return "kind = \"path-generation\"\n[target]\n"
         "points = [[0, 0], [1, 0.2], [2, 1], [1, 1.4], [0, 1]]\nclosed = true\n[mechanism]\n"
         "type = \"" +
         type + "\"\n[bounds]\nlength = [0.1, 9]\n[tolerance]\n\n" + lines;
}

const std::vector<FaultCase> kCases{
    {"ListForALength",
     rocker("length = [0.1, 0.2]\n"),
     {{9, 10,
       "expected a length, 0 or from 1e-100 to 1e100, {plus, minus}, or a grade as \"IT8\""}}},
    {"TruthForADimension", rocker("crank = true\n"), {{9, 9, "{plus, minus}, or a grade"}}},
    {"NegativeSide",
     rocker("crank = {plus = -1}\n"),
     {{9, 17, "plus is -1; expected a length, 0 or from 1e-100 to 1e100"}}},
    {"NumberForYield", rocker("length = 1\nyield = 3\n"), {{10, 9, "a table [tolerance.yield]"}}},
    {"YieldOfAnAngle",
     rocker("length = 1\nyield = {max_error = 3}\n"),
     {{10, 22, "is of an angle here; expected max_error_deg"}}},
    {"YieldOfAPoint",
     rocker("length = 1\nof = \"C\"\nyield = {max_error_deg = 3}\n"),
     {{11, 26, "is of a length here; expected max_error"}}},
    {"YieldOfNothing",
     rocker("length = 1\nyield = {}\n"),
     {{10, 9, "max_error_deg is missing; expected the error that must not be exceeded"}}},
    {"YieldOfNoSamples",
     rocker("length = 1\nsamples = 0\nyield = {max_error_deg = 3}\n"),
     {{11, 9,
       "is a share of samples, of which there are none; expected tolerance.samples above 0"}}},
    {"NumberForAllocate",
     rocker("length = 1\nallocate = 3\n"),
     {{10, 12, "a table [tolerance.allocate]"}}},
    {"AllocateForAnAngle",
     rocker("length = 1\nallocate = {limit = 3}\n"),
     {{10, 21, "is of an angle here; expected limit_deg"}}},
    {"NothingLeft",
     rocker("length = 40\n"),
     {{9, 10, "crank is 40 long, of which a tolerance of -40 leaves nothing; expected less"}}},
    {"GradeWithoutTheSize",
     "kind = \"analysis\"\nlength_unit = \"m\"\n[mechanism]\ntype = \"scotch-yoke\"\ncrank = 9\n"
     "[tolerance]\ngrade = \"IT8\"\n",
     {{7, 9, "crank is 9000 mm long, for which IT8 has no tolerance"}}},
    {"NoLinkOfTheChain",
     path("watt-1", "ZZ = 0.1\nlength = 0.1\n"),
     {{11, 1, "unknown key \"ZZ\" in [tolerance]"}}},
    {"NoPinOfTheChain",
     path("watt-1", "length = 0.1\nclearance = {Z = 0.1}\n"),
     {{12, 14, "unknown key \"Z\" in [tolerance.clearance]"}}},
    {"FaultyChain", path("watt-9", "BC = 0.1\n"), {{6, 8, "watt-9"}}},
};

class ToleranceFaultsTest : public ::testing::TestWithParam<FaultCase> {};

TEST_P(ToleranceFaultsTest, EachAtItsPlace) {
  expect_faults(GetParam());
}

INSTANTIATE_TEST_SUITE_P(All, ToleranceFaultsTest, ::testing::ValuesIn(kCases), name_of_case);

// The structure is known before its dimensions are.
TEST(ToleranceNames, LinksAndPinsOfAStructureHaveTheirNames) {
  for (const std::string lines : {"crank = 0.1\nBC = 0.2\nCD = {plus = 0.1, minus = 0}\nP = "
                                  "0.3\nclearance = {A = 0.1, C = 0.1}\n",
                                  "BC = \"IT9\"\n"}) {
    const auto read = parse_task<ChainPathProblem>(path("watt-1", lines));
    EXPECT_TRUE(read) << read.error().front().message;
  }
  const auto read = parse_task<ChainPathProblem>(path("watt-1", "BC = 0.2\nP = 0.3\n"));
  ASSERT_TRUE(read);
  ASSERT_EQ(read->tolerances->dimensions.size(), 2U);
  EXPECT_EQ(read->tolerances->dimensions[0].dimension, "BC");
}

// All six-bars have a crank, but their other links join other points.
TEST(ToleranceNames, SeveralStructuresHaveWhatIsCommonToThem) {
  EXPECT_TRUE(
      parse_task<ChainPathProblem>(path("six-bar", "crank = 0.1\nclearance = {A = 0.1}\n")));
  const auto read = parse_task<ChainPathProblem>(path("six-bar", "FH = 0.1\ncrank = 0.1\n"));
  ASSERT_FALSE(read);
  EXPECT_NE(read.error().front().message.find("unknown key \"FH\" in [tolerance]"),
            std::string::npos)
      << read.error().front().message;
}

}  // namespace
}  // namespace cognate::problems::tolerance_faults_test
