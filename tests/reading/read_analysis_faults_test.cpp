// Every class of fault of an analysis file, with its exact place and what its message must say.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/reading/fault_cases.hpp"

namespace cognate::problems::read_analysis_faults_test {
namespace {

// A four-bar with `lines` after its dimensions: the first of them is line 8.
std::string four_bar(const std::string& lines) {
  return "kind = \"analysis\"\n[mechanism]\ntype = \"four-bar\"\n"
         "fixed_pivots = [[0, 0], [4, 0]]\ncrank = 1\ncoupler = 3\nrocker = 3\n" +
         lines;
}

// A mechanism of `type` with `lines` after it: the first of them is line 4.
std::string simple(const std::string& type, const std::string& lines) {
  return "kind = \"analysis\"\n[mechanism]\ntype = \"" + type + "\"\n" + lines;
}

const std::string kChain =
    "kind = \"analysis\"\nmechanism.type = \"chain\"\n"
    "pivot = [{name = \"A\", at = [0, 0]}, {name = \"D\", at = [4, 0]}]\n";

// A chain with pivots A and D, and `lines` from line 4.
std::string chain(const std::string& lines) {
  return kChain + lines;
}

// A chain of a crank A-B and a rocker C-D, and `lines` from line 6.
std::string six_bar(const std::string& lines) {
  return kChain +
         "crank = {at = \"A\", pin = \"B\", length = 1}\n"
         "dyad = [{type = \"RRR\", joins = [\"B\", \"D\"], lengths = [3, 3], new = \"C\"},\n" +
         lines + "]\n";
}

const std::vector<FaultCase> kSimpleCases = {
    {"NoMechanism", "kind = \"analysis\"\n", {{1, 1, "mechanism.type is missing; allowed are"}}},
    {"TheRestOfAnUnknownMechanism",
     "kind = \"analysis\"\nmechanism.type = \"chian\"\n[[link]]\nname = \"rod\"\nmass = -1\n"
     "[drive]\nsteps = 0\n[output]\nwnat = [\"position\"]\n",
     {{2, 18, "perhaps for \"chain\""},
      {5, 8, "link[1].mass is -1"},
      {7, 9, "drive.steps is 0"},
      {9, 1, "did you mean \"want\"?"}}},
    {"LayersWithoutSizes",
     four_bar("[layers]\nclearance = -1\n"),
     {{8, 1, "layers.link_width is missing; expected a length"},
      {8, 1, "layers.pin_diameter is missing; expected a length"},
      {9, 13, "layers.clearance is -1; expected a length, 0 or from"}}},
    {"LayersOfOtherLinks",
     four_bar("[layers]\nlink_width = 0.2\npin_diameter = 0.3\n"
              "widths = {couplr = 0.4, frame = 1}\n"),
     {{10, 16, "layers.pin_diameter is 0.3, wider than a link of 0.2"},
      {11, 11, "unknown key \"couplr\" in [layers.widths]; did you mean \"coupler\"?"},
      {11, 25, "unknown key \"frame\" in [layers.widths]; allowed are"}}},
    {"TypeMisspelt",
     "kind = \"analysis\"\n[mechanism]\ntype = \"four bar\"\ncrank = 1\n[[link]]\nmass = 1\n",
     {{3, 8, "perhaps for \"four-bar\""}, {5, 1, "link[1].between is missing"}}},
    {"NoDimensions",
     simple("four-bar", ""),
     {{2, 1, "fixed_pivots is missing"},
      {2, 1, "crank is missing"},
      {2, 1, "coupler is missing"},
      {2, 1, "rocker is missing"}}},
    {"WrongNumbers",
     "kind = \"analysis\"\n[mechanism]\ntype = \"four-bar\"\nfixed_pivots = [[0, 0], [nan, 0]]\n"
     "crank = 0\ncoupler = -1\nrocker = 1e300\n",
     {{4, 26, "is nan"}, {5, 9, "is 0"}, {6, 11, "is -1"}, {7, 10, "1e-30 to 1e30"}}},
    {"PivotsCoincide",
     "kind = \"analysis\"\n[mechanism]\ntype = \"four-bar\"\nfixed_pivots = [[1, 2], [1, 2]]\n"
     "crank = 1\ncoupler = 1\nrocker = 1\n",
     {{4, 16, "coincide; expected two different points"}}},
    {"UnknownKey", four_bar("cuopler = 3\n"), {{8, 1, "did you mean \"coupler\"?"}}},
    {"KeyOfAnotherType",
     four_bar("offset = 3\n"),
     {{8, 1, "unknown key \"offset\" in [mechanism]; allowed are"}}},
    {"TableOfAProblem",
     four_bar("[target]\npoints = []\n"),
     {{8, 2, "unknown key \"target\"; allowed are \"kind\""}}},
    {"GuideBarCrossedWithoutOffset",
     simple("guide-bar", "fixed_pivots = [[0, 0], [1, 0]]\ncrank = 2\nassembly = \"crossed\"\n"),
     {{6, 12, "where there is but one assembly"}}},
    {"SlotAlongTheSlide",
     simple("scotch-yoke", "crank = 1\nslot_deg = 180\n"),
     {{5, 12, "parallel to the slide line"}}},
    {"LinesOfTheTrammelParallel",
     simple("elliptic-trammel", "length = 1\nsecond_line_deg = 360\n"),
     {{5, 19, "parallel to the first line"}}},
    {"TangentGeneratorWithoutOffset",
     simple("tangent-generator", "offset = 0\n"),
     {{4, 10, "the distance of the slide line from the pivot, not 0,"}}},
    {"PointNamedTwice",
     four_bar("[[point]]\nname = \"B\"\non = \"coupler\"\nat = [1, 1]\n"
              "[[point]]\nname = \"Q\"\non = \"coupler\"\nat = [1, 1]\n"
              "[[point]]\nname = \"Q\"\non = \"rocker\"\nat = [1, 1]\n"),
     {{9, 8, "is \"B\", which is a point already"}, {17, 8, "is \"Q\", which is a point already"}}},
    {"PointNamedAsABody",
     four_bar("[[point]]\nname = \"rocker\"\non = \"coupler\"\nat = [1, 1]\n"),
     {{9, 8, "which is a body"}}},
    {"NamesThatAreNone",
     four_bar("[[point]]\nname = \"\"\non = \"coupler\"\nat = [1, 1]\n"
              "[[point]]\nname = \"a,b\"\non = \"coupler\"\nat = [1, 1]\n"),
     {{9, 8, "is \"\"; expected a name of 1 to 40 letters"},
      {13, 8, "is \"a,b\"; expected a name of"}}},
    {"PointOnNothing",
     four_bar("[[point]]\nname = \"Q\"\non = \"cuopler\"\nat = [1, 1]\n"),
     {{10, 6, "perhaps for \"coupler\", which is no part of this mechanism"}}},
    {"PointWithoutItsKeys",
     four_bar("[[point]]\nat = [1, 1, 1]\n"),
     {{8, 1, "point[1].name is missing"},
      {8, 1, "point[1].on is missing"},
      {9, 6, "point[1].at has 3 entries"}}},
    {"LinkOfTwoBodies",
     four_bar("[[link]]\nbetween = [\"A\", \"C\"]\nmass = 1\ncentre = [0, 0]\n"),
     {{9, 17, "no body has both \"A\" (on \"frame\", \"crank\") and \"C\" (on"}}},
    {"LinkOfOnePoint",
     four_bar("[[link]]\nbetween = \"C\"\nmass = 1\ncentre = [0, 0]\n"),
     {{9, 11, "the point \"C\", which is the pin of no slider"}}},
    {"LinkOfCoincidentPoints",
     four_bar("[[link]]\nbetween = [\"C\", \"C\"]\nmass = 1\ncentre = [0, 0]\n"),
     {{9, 17, "coincide and give no direction"}}},
    {"LinkTwice",
     four_bar("[[link]]\nname = \"rocker\"\nmass = 1\ncentre = [0, 0]\n"
              "[[link]]\nbetween = [\"C\", \"D\"]\nmass = 1\ncentre = [0, 0]\n"),
     {{12, 1, "gives \"rocker\" a second time"}}},
    {"LinkOfTheFrame",
     four_bar("[[link]]\nbetween = [\"A\", \"D\"]\nmass = 1\ncentre = [0, 0]\n"),
     {{8, 1, "is the frame, which does not move"}}},
    {"LinkNamedTwoWays",
     four_bar("[[link]]\nname = \"rocker\"\nbetween = [\"C\", \"D\"]\nmass = 1\n"),
     {{9, 8, "is given beside link[1].between"}}},
    {"LinkWithoutMass",
     four_bar("[[link]]\nname = \"rocker\"\ncentre = [1, 0]\n"),
     {{8, 1, "link[1].mass is missing"}}},
    {"LinkWithoutCentre",
     four_bar("[[link]]\nname = \"rocker\"\nmass = 1\n"),
     {{8, 1, "link[1].centre is missing"}}},
    {"LoadOnNothing",
     four_bar("[[load]]\non = \"E\"\nforce = [1, 0]\n[[load]]\ntorque = 1\n"),
     {{9, 6, "which is no part of this mechanism; there are the bodies \"frame\", \"crank\""},
      {11, 1, "load[2].on is missing"}}},
    {"LoadOnTheFrame",
     four_bar("[[load]]\non = \"frame\"\nforce = [1, 0]\n"),
     {{9, 6, "where a load does nothing"}}},
    {"LoadPlacedTwice",
     four_bar("[[load]]\non = \"C\"\nat = [1, 0]\nforce = [1, 0]\n"),
     {{10, 6, "is given for the point \"C\""}}},
    {"LoadWithoutForce", four_bar("[[load]]\non = \"C\"\n"), {{8, 1, "load[1].force is missing"}}},
    {"LoadWhenNever",
     four_bar("[[load]]\non = \"C\"\nforce = [1, 0]\nwhen = \"retreat\"\n"
              "[[load]]\non = \"C\"\nforce = [1, 0]\nwhen = [30, 30]\n"
              "[[load]]\non = \"C\"\nforce = [1, 0]\nwhen = 30\nstroke = [0.9, 0.1]\n"
              "[[load]]\non = \"C\"\nforce = [1, 0]\nstroke = [0, 1.5]\n"),
     {{11, 8, "allowed are \"always\", \"advance\", \"return\""},
      {15, 8, "more than a position"},
      {19, 8, "or an interval [from_deg, to_deg]"},
      {20, 10, "is empty"},
      {24, 14, "a fraction from 0 to 1"}}},
    {"GravityIsNoNumber", "gravity = 9.81\n" + four_bar(""), {{1, 11, "expected [x, y]"}}},
    {"GravityTwice",
     "gravity = [0, -9.81]\n" + four_bar("gravity = [0, -9.81]\n"),
     {{9, 11, "give gravity or mechanism.gravity, not both"}}},
    {"DriveOfASlider",
     four_bar("[drive]\nstart = 0\nend_deg = 0\nsteps = 1000001\n"),
     {{9, 9, "an angle drives this mechanism; expected start_deg"},
      {10, 11, "is start_deg, so that nothing moves"},
      {11, 9, "an integer from 1 to 1000000"}}},
    {"OutputOfNothing",
     four_bar("[output]\nposition = false\nvelocity = false\nacceleration = false\n"
              "transmission = false\n"),
     {{8, 1, "is empty"}}},
    {"OutputWantsTheUnknown",
     four_bar("[output]\nwant = [\"positions\", \"E\"]\npoints = [\"F\"]\n"),
     {{9, 9, "perhaps for \"position\""},
      {9, 22, "and the points \"A\", \"B\", \"C\", \"D\""},
      {10, 11, "is no point of this mechanism"}}},
    {"InstantGeometryOfNoBody",
     four_bar("[output]\ninstant_geometry = [\"couplr\", \"frame\"]\n"),
     {{9, 21, "perhaps for \"coupler\""}, {9, 31, "has \"frame\", which does not move"}}},
    {"CognatesWithoutACouplerPoint",
     four_bar("[output]\ncognates = true\n"),
     {{9, 12, "expected a four-bar with a coupler_point"}}},
    {"OutputSaidTwice",
     four_bar("[output]\nwant = [\"position\"]\nvelocity = true\n"),
     {{10, 12, "is given beside output.want"}}},
};

const std::vector<FaultCase> kChainCases = {
    {"NoDyads",
     "kind = \"analysis\"\n[mechanism]\ntype = \"chain\"\n[[pivot]]\nname = \"A\"\nat = [0, 0]\n"
     "[crank]\nat = \"A\"\npin = \"B\"\nlength = 1\n",
     {{2, 1, "dyad is missing; a chain has one [[dyad]] or more"}}},
    {"NoDrive",
     chain("[[dyad]]\ntype = \"RRR\"\njoins = [\"A\", \"D\"]\nlengths = [1, 1]\nnew = \"C\"\n"),
     {{1, 1, "mobility 3(n - 1) - 2j = 0 with n = 3 bodies and j = 3 joints"},
      {6, 9, "\"A\" and \"D\", both points of \"frame\""}}},
    {"OutputThatDoesNotMove",
     six_bar("") + "mechanism.output = \"frame\"\n",
     {{7, 20, "mechanism.output is \"frame\", which does not move; expected a body"}}},
    {"OutputThatDrives",
     six_bar("") + "mechanism.output = \"crank\"\n",
     {{7, 20, "mechanism.output is \"crank\", which is the drive itself; expected a body"}}},
    {"OutputThatIsNone",
     six_bar("") + "mechanism.output = \"CE\"\n",
     {{7, 20, "mechanism.output has \"CE\""}}},
    {"TwoDrives",
     six_bar("") + "slider = {slide = {through = \"A\"}, pin = \"E\"}\n",
     {{7, 10, "mobility 3(n - 1) - 2j = 2 with n = 5 bodies and j = 5 joints"}}},
    {"PivotThatNothingJoins",
     "kind = \"analysis\"\nmechanism.type = \"chain\"\npivot = [{name = \"A\", at = [0, 0]}, "
     "{name = \"D\", at = [4, 0]},\n{name = \"E\", at = [5, 0]}]\n"
     "crank = {at = \"A\", pin = \"B\", length = 1}\n"
     "dyad = [{type = \"RRR\", joins = [\"B\", \"D\"], lengths = [3, 3], new = \"C\"}]\n",
     {{4, 9, "is \"E\", which nothing joins: the rest has mobility 3(n - 1) - 2j = 1"}}},
    {"CrankWithoutItsKeys",
     chain("[crank]\nlength = \"one\"\n[[dyad]]\ntype = \"RRR\"\njoins = [\"B\", \"D\"]\n"
           "lengths = [1, 1]\nnew = \"C\"\n"),
     {{4, 1, "crank.at is missing"},
      {4, 1, "crank.pin is missing"},
      {5, 10, "is \"one\"; expected a length"},
      {8, 10, "has \"B\", which is no point of this mechanism"}}},
    {"JoinsALaterPoint",
     six_bar("{type = \"RRR\", joins = [\"F\", \"D\"], lengths = [3, 3], new = \"E\"},\n"
             "{type = \"RRR\", joins = [\"E\", \"B\"], lengths = [3, 3], new = \"F\"}"),
     {{6, 25,
       "has \"F\", which is placed only later; so far there are \"A\", \"D\", \"B\", \"C\""}}},
    {"JoinsTheUnknown",
     six_bar("{type = \"RRR\", joins = [\"X\", \"D\"], lengths = [3, 3], new = \"E\"},\n"
             "{type = \"RRR\", joins = [\"E\", \"B\"], lengths = [3, 0], new = \"F\"}"),
     {{6, 25, "has \"X\", which is no point of this mechanism"},
      {7, 50, "is 0; expected a length"}}},
    {"JoinsOnePointTwice",
     six_bar("{type = \"RRR\", joins = [\"C\", \"C\"], lengths = [3, 3], new = \"E\"}"),
     {{6, 24, "has \"C\" twice"}}},
    {"BothJointsOnOneBody",
     six_bar("{type = \"RRR\", joins = [\"B\", \"C\"], lengths = [3, 3], new = \"E\"},\n"
             "{type = \"RPR\", joins = [\"A\", \"B\"]},\n"
             "{type = \"RRP\", joins = \"B\", length = 3, new = \"F\", "
             "slide = {through = \"B\", on = \"BC\"}}"),
     {{6, 24, "both points of \"BC\", so that the group cannot move on it (mobility 0)"},
      {7, 24, "both points of \"crank\""},
      {8, 24, "a point of \"BC\", which also carries the slide"}}},
    {"SlidesOnOneBodyOrParallel",
     six_bar(
         "{type = \"PRP\", slides = [{through = \"A\"}, {through = \"D\", direction_deg = 90}], "
         "new = \"E\"},\n{type = \"RRP\", joins = \"C\", length = 3, new = \"F\", "
         "slide = {through = [0, 0], direction_deg = 30}},\n"
         "{type = \"PRP\", slides = [{through = \"F\", on = \"F\", direction_deg = 150}, "
         "{through = \"D\"}], new = \"G\"}"),
     {{6, 25, "are both on \"frame\""}, {8, 25, "stay parallel and never cross"}}},
    {"SlotAlongTheSlide",
     six_bar(
         "{type = \"RPP\", joins = \"C\", slot_deg = 0, slide = {through = \"D\"}, new = \"E\"}"),
     {{6, 40, "parallel to the slide"}}},
    {"SlideThroughAPointOfAnotherBody",
     six_bar("{type = \"RRP\", joins = \"B\", length = 3, new = \"E\", slide = {through = \"C\"}}"),
     {{6, 71, "which is no point of \"frame\" but of \"BC\", \"CD\""}}},
    {"SlideWithoutItsKeys",
     six_bar("{type = \"RRP\", joins = \"C\", length = 3, new = \"E\", slide = {on = \"DC\"}},\n"
             "{type = \"RRP\", joins = \"C\", length = 3, new = \"F\"}"),
     {{6, 60, "slide.through is missing"},
      {6, 66, "has \"DC\", which is no body of this mechanism"},
      {7, 1, "slide is missing"}}},
    {"UnknownDyad",
     six_bar("{type = \"RRRP\", joins = [\"E\"], other = 1},\n{joins = []}"),
     {{6, 9, "perhaps for \"RRR\""}, {7, 1, "dyad[3].type is missing"}}},
    {"KeysOfOtherDyads",
     six_bar("{type = \"RPR\", joins = [\"C\", \"A\"], lengths = [1, 1]}"),
     {{6, 36, "unknown key \"lengths\" in [dyad[2]]"}}},
    {"BodyNamesThatAreTaken",
     six_bar("{type = \"RPR\", joins = [\"C\", \"A\"], names = [\"crank\", \"B\"]}"),
     {{6, 45, "is a body already"}, {6, 54, "which is a point and not the pin of this body"}}},
    {"TwoBlocksOnOnePin",
     six_bar("{type = \"RPR\", joins = [\"C\", \"A\"]},\n"
             "{type = \"RPP\", joins = \"C\", slide = {through = \"A\"}, new = \"E\"}"),
     {{7, 1, "is \"C\", which is a body already"}}},
    {"PointNamedTwice",
     six_bar("{type = \"RRR\", joins = [\"C\", \"A\"], lengths = [1, 1], new = \"B\"}"),
     {{6, 60, "is \"B\", which is a point already"}}},
    {"TablesInBothPlaces",
     chain("[[mechanism.pivot]]\nname = \"E\"\nat = [0, 0]\n[crank]\nat = \"A\"\npin = \"B\"\n"
           "length = 1\n[[dyad]]\ntype = \"RRR\"\njoins = [\"B\", \"D\"]\nlengths = [3, 3]\n"
           "new = \"C\"\n"),
     {{4, 1, "give pivot or mechanism.pivot, not both"}}},
    {"NoArrayOfTables",
     "kind = \"analysis\"\npivot = 3\ndyad = [1]\n[mechanism]\ntype = \"chain\"\n[crank]\n"
     "at = \"A\"\npin = \"B\"\nlength = 1\n",
     {{2, 9, "pivot is an integer; expected an array of tables [[pivot]]"},
      {3, 9, "dyad[1] is an integer; expected a table"},
      {7, 6, "has \"A\", which is no point"}}},
    {"CylinderNeedsPivotsApartAndLengths",
     "kind = \"analysis\"\nmechanism.type = \"chain\"\npivot = [{name = \"A\", at = [0, 0]}]\n"
     "cylinder = {at = \"A\", about = \"A\", pin = \"P\", length = 1}\n"
     "[drive]\nstart = 0\nend = 2\n",
     {{4, 31, "so that the cylinder's length does not turn the link"},
      {6, 9, "drive.start is 0, as the length of the cylinder; expected one above 0"}}},
    {"CylinderIsOneDrive",
     "kind = \"analysis\"\nmechanism.type = \"chain\"\npivot = [{name = \"A\", at = [0, 0]}]\n"
     "slider = {slide = {through = [0, 0]}, pin = \"B\"}\n"
     "cylinder = {at = \"A\", about = \"A\", pin = \"P\", length = 1}\n",
     {{5, 12, "cylinder is given beside slider"}}},
    {"DrivingSliderWantsLengths",
     "kind = \"analysis\"\nmechanism.type = \"chain\"\npivot = [{name = \"D\", at = [4, 0]}]\n"
     "slider = {slide = {through = [0, 0]}, pin = \"B\"}\n"
     "dyad = [{type = \"RRR\", joins = [\"B\", \"D\"], lengths = [3, 3], new = \"C\"}]\n"
     "[drive]\nstart_deg = 3\n",
     {{6, 1, "drive.end is missing"}, {7, 13, "a slider drives this mechanism; expected start"}}},
};

class ReadAnalysisFaultsTest : public ::testing::TestWithParam<FaultCase> {};

TEST_P(ReadAnalysisFaultsTest, EachAtItsPlace) {
  expect_faults(GetParam());
}

INSTANTIATE_TEST_SUITE_P(Simple, ReadAnalysisFaultsTest, ::testing::ValuesIn(kSimpleCases),
                         name_of_case);
INSTANTIATE_TEST_SUITE_P(Chain, ReadAnalysisFaultsTest, ::testing::ValuesIn(kChainCases),
                         name_of_case);

TEST(ReadAnalysisFaults, ValuesOfMillionsOfRowsMustFitIntoMemory) {
  std::string text = six_bar("");
  text += "[drive]\nsteps = 1000000\n";
  for (int i = 0; i < 20; ++i) {
    text += "[[point]]\nname = \"P" + std::to_string(i) + "\"\non = \"BC\"\nat = [0, 1]\n";
  }
  const auto task = parse_task(text);
  ASSERT_FALSE(task);
  ASSERT_EQ(task.error().size(), 1U);
  EXPECT_NE(task.error()[0].message.find("for 28 bodies and points; at most 714285"),
            std::string::npos)
      << task.error()[0].message;
}

TEST(ReadAnalysisFaults, AFileOfAnotherKindSaysWhichIsExpected) {
  const auto problem = parse_task<PathProblem>("title = \"x\"\n" + four_bar(""));
  ASSERT_FALSE(problem);
  ASSERT_EQ(problem.error().size(), 1U);
  EXPECT_EQ(problem.error()[0].line, 2U);
  EXPECT_EQ(problem.error()[0].column, 8U);
  EXPECT_EQ(problem.error()[0].message,
            "kind is \"analysis\"; expected kind = \"path-generation\"");
}

}  // namespace
}  // namespace cognate::problems::read_analysis_faults_test
