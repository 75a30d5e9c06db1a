// What a file of kind "motion-generation" says, and every fault that it may have.

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "tests/reading/fault_cases.hpp"

namespace cognate::problems::motion_problem_test {
namespace {

// The first of `lines` is line 3.
std::string file(const std::string& lines) {
  return "kind = \"motion-generation\"\n[target]\n" + lines;
}

const std::string kTwo = "poses = [[0, 0, 0], [1, 2, 30]]\n";
const std::string kThree = "poses = [[0, 0, 0], [1, 2, 30], [3, 2, 50]]\n";
const std::string kFour = "poses = [[0, 0, 0], [1, 2, 30], [3, 2, 50], [4, 1, 60]]\n";

const std::string kSix =
    "poses = [[0, 0, 0], [1, 0, 10], [2, 0, 30], [4, 0, 50], [5, 1, 60], [6, 1, 80]]\n";

MotionProblem read(const std::string& lines) {
  const auto problem = parse_task(file(lines));
  if (!problem) {
    ADD_FAILURE() << problem.error().front().message;
    return {};
  }
  return std::get<MotionProblem>(*problem);
}

TEST(MotionProblemTest, Poses) {
  const MotionProblem problem =
      read(kThree + "[mechanism]\nfixed_pivots = [[1, 2], [3, 4]]\ndyads = [\"RP\", \"RR\"]\n" +
           "[bounds]\nlength = [0.5, 9]\n");
  ASSERT_EQ(problem.poses.size(), 3U);
  EXPECT_DOUBLE_EQ(problem.poses[1].angle, kPi / 6);
  ASSERT_EQ(problem.fixed_pivots.size(), 2U);
  EXPECT_EQ(problem.fixed_pivots[1], (Vec2d{3, 4}));
  EXPECT_EQ(problem.dyads, (std::vector{synthesis::DyadKind::rr, synthesis::DyadKind::rp}));
  EXPECT_EQ(problem.bounds.rocker.value().max, 9);
  EXPECT_FALSE(problem.designs_given);
}

TEST(MotionProblemTest, MoreThanFivePosesAreFitted) {
  EXPECT_EQ(read(kFour).method, MotionMethod::exact);
  const MotionProblem problem = read(kSix);
  EXPECT_EQ(problem.method, MotionMethod::least_squares);
  // The root mean squared distance from (3, 1/3) of the six places.
  EXPECT_NEAR(problem.angle_weight, std::sqrt((9 + 4 + 1 + 1 + 4 + 9) / 6.0 + 2 / 9.0), 1e-14);
  EXPECT_EQ(read(kSix + "angle_weight = 2.5\n").angle_weight, 2.5);
  EXPECT_EQ(read(kFour + "method = \"least-squares\"\n").method, MotionMethod::least_squares);
  const MotionProblem given =
      read(kSix +
           "[mechanism]\nfixed_pivots = [[0, 0], [1, 0]]\nmoving_pivots = [[0, 0], [1, "
           "0]]\ncrank = 2\nrocker = 3\n[bounds]\nmoving_pivot_d = [[-1, -2], [3, 4]]\n");
  EXPECT_EQ(given.moving_pivots.size(), 2U);
  EXPECT_EQ(given.rocker, 3);
  EXPECT_EQ(given.moving_bounds[1].value().max, (Vec2d{3, 4}));
}

TEST(MotionProblemTest, SegmentsAreBodiesWithTheirEndsAsPivots) {
  const MotionProblem problem = read("segments = [[[1, 1], [1, 3]], [[5, 5], [3, 5]]]\n");
  ASSERT_EQ(problem.poses.size(), 2U);
  EXPECT_EQ(problem.poses[0].at, (Vec2d{1, 1}));
  EXPECT_DOUBLE_EQ(problem.poses[0].angle, kRightAngle);
  EXPECT_DOUBLE_EQ(std::abs(problem.poses[1].angle), kPi);
  ASSERT_EQ(problem.moving_pivots.size(), 2U);
  EXPECT_EQ(problem.moving_pivots[1], (Vec2d{2, 0}));
}

const std::vector<FaultCase> kCases = {
    {"NoTarget", "kind = \"motion-generation\"\n", {{1, 1, "target.poses is missing"}}},
    {"Both",
     file(kTwo + "segments = [[[1, 1], [1, 3]], [[5, 5], [3, 5]]]\n"),
     {{4, 12, "beside target.poses"}}},
    {"OnePose", file("poses = [[0, 0, 0]]\n"), {{3, 9, "has 1 pose; expected 2 to"}}},
    {"SixPosesExactly",
     file(kSix + "method = \"exact\"\n"),
     {{4, 10, "is \"exact\" with 6 poses; at most five can be met"}}},
    {"TwoPosesNearby",
     file(kTwo + "method = \"least-squares\"\n"),
     {{4, 10, "is \"least-squares\" with 2 poses; expected at least three"}}},
    {"UnknownMethod", file(kSix + "method = \"least\"\n"), {{4, 10, "\"least-squares\""}}},
    {"ZeroWeight", file(kSix + "angle_weight = 0\n"), {{4, 16, "is 0; expected a length"}}},
    {"NegativeWeight", file(kSix + "angle_weight = -1\n"), {{4, 16, "is -1; expected a length"}}},
    {"WeightOfExactPoses",
     file(kThree + "angle_weight = 1\n"),
     {{4, 16, "is given, but the poses are met exactly"}}},
    {"NotANumberInSix",
     file("poses = [[0, 0, 0], [1, 0, nan], [2, 0, 3], [4, 0, 5], [5, 1, 5], [6, 1, 5]]\n"),
     {{3, 28, "nan"}}},
    {"SlidesAlone",
     file(kSix + "[mechanism]\ndyads = [\"PR\", \"RP\"]\n"),
     {{5, 9, "leaves \"RR\" out"}}},
    {"LineOfSix",
     file(kSix + "[mechanism]\nfixed_pivot_line = [1, 0, 2]\n"),
     {{5, 20, "goes with two poses only"}}},
    {"MovingBoundsOfExactPoses",
     file(kThree + "[bounds]\nmoving_pivot_a = [[0, 0], [1, 1]]\n"),
     {{5, 18, "is given, but the poses are met exactly"}}},
    {"MovingPivotOutsideItsBounds",
     file(kSix + "[mechanism]\nmoving_pivots = [[5, 5]]\n[bounds]\n"
                 "moving_pivot_a = [[0, 0], [1, 1]]\n"),
     {{7, 18, "does not contain the moving pivot"}}},
    {"FixedPivotOutsideItsBounds",
     file(kSix + "[mechanism]\nfixed_pivots = [[0, 0], [5, 5]]\n[bounds]\n"
                 "pivot_d = [[0, 0], [1, 1]]\n"),
     {{7, 11, "does not contain the fixed pivot"}}},
    {"CrankOutsideItsBounds",
     file(kSix + "[mechanism]\ncrank = 5\n[bounds]\ncrank = [1, 2]\n"),
     {{7, 9, "does not allow the crank of 5"}}},
    {"CeresWithBoundedFrame",
     file(kSix + "[bounds]\nframe = [1, 2]\n[solve]\nsolver = \"ceres\"\n"),
     {{7, 10, "does not honour bounds of coupler and frame"}}},
    {"AgsWithManyUnknowns",
     file(kSix + "[solve]\nsolver = \"ags\"\n"),
     {{5, 10, "takes 10 unknowns at most, and there are 16"}}},
    {"ShortPose", file("poses = [[0, 0], [1, 2, 3]]\n"), {{3, 10, "has 2 entries"}}},
    {"WordInPose",
     file("poses = [[0, 0, \"x\"], [1, 2, 3]]\n"),
     {{3, 17, "is \"x\"; expected a number"}}},
    {"HugeAngle", file("poses = [[0, 0, 1e6], [1, 2, 3]]\n"), {{3, 10, "pose 1"}}},
    {"NotANumber", file("poses = [[nan, 0, 0], [1, 2, 3]]\n"), {{3, 11, "nan"}}},
    {"StretchedSegment",
     file("segments = [[[0, 0], [1, 0]], [[0, 1], [1.1, 1]]]\n"),
     {{3, 31, "a difference of 0.1"}}},
    {"PointSegment",
     file("segments = [[[0, 0], [0, 0]], [[0, 1], [1, 1]]]\n"),
     {{3, 13, "has no length"}}},
    {"ThreePivots",
     file(kTwo + "[mechanism]\nfixed_pivots = [[0, 0], [1, 0], [2, 0]]\n"),
     {{5, 16, "has 3 pivots"}}},
    {"TooManyPivots",
     file(kThree +
          "[mechanism]\nfixed_pivots = [[0, 0], [1, 0]]\nmoving_pivots = [[0, 0], [1, 0]]\n"),
     {{6, 17, "more than two pivots"}}},
    {"OnePivotTwice",
     file(kThree + "[mechanism]\nfixed_pivots = [[1, 0], [1, 0]]\n"),
     {{5, 16, "one pivot twice"}}},
    {"PivotsOfFour",
     file(kFour + "[mechanism]\nfixed_pivots = [[0, 0], [1, 0]]\n"),
     {{5, 16, "is given with 4 poses"}}},
    {"LineOfThree",
     file(kThree + "[mechanism]\nmoving_pivots = [[0, 0]]\nfixed_pivot_line = [1, 0, 2]\n"),
     {{6, 20, "only two poses"}}},
    {"LineWithoutPivot",
     file(kTwo + "[mechanism]\nfixed_pivot_line = [1, 0, 2]\n"),
     {{5, 20, "without mechanism.moving_pivots"}}},
    {"NoLine",
     file(kTwo + "[mechanism]\nmoving_pivots = [[0, 0]]\nfixed_pivot_line = [0, 0, 2]\n"),
     {{6, 20, "a = b = 0"}}},
    {"LengthWithoutPivot", file(kTwo + "[mechanism]\ncrank = 2\n"), {{5, 9, "without a pivot"}}},
    {"RockerWithOnePivot",
     file(kTwo + "[mechanism]\nmoving_pivots = [[0, 0]]\ncrank = 2\nrocker = 3\n"),
     {{7, 10, "without a second pivot"}}},
    {"LengthOfThree",
     file(kThree + "[mechanism]\nmoving_pivots = [[0, 0]]\ncrank = 2\n"),
     {{6, 9, "only two poses"}}},
    {"Dyads",
     file(kTwo + "[mechanism]\ndyads = [\"RR\", \"PP\"]\n"),
     {{5, 16, "allowed are \"RR\", \"PR\", \"RP\""}}},
    {"UnknownKey",
     file(kTwo + "[mechanism]\nmoving_pivot = [[0, 0]]\n"),
     {{5, 1, "did you mean \"moving_pivots\""}}},
    {"PivotOutsideRegion",
     file(kThree + "[mechanism]\nfixed_pivots = [[9, 9], [1, 0]]\n[constraints]\npivot_region = "
                   "[[0, 0], [2, 2]]\n"),
     {{7, 16, "does not contain the given pivot [9, 9]"}}},
};

class MotionFaults : public ::testing::TestWithParam<FaultCase> {};

TEST_P(MotionFaults, AreFound) {
  expect_faults(GetParam());
}

INSTANTIATE_TEST_SUITE_P(MotionProblemTest, MotionFaults, ::testing::ValuesIn(kCases),
                         name_of_case);

}  // namespace
}  // namespace cognate::problems::motion_problem_test
