/// `solve.objectives` and the bounds on the error: what they mean, and what is wrong with them.
#include <gtest/gtest.h>

#include <string>
#include <variant>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "tests/reading/fault_cases.hpp"

namespace cognate::problems::objectives_test {
namespace {

/// Lines of [constraints] begin at 5, [solve] comes last.
std::string path(const std::string& constraints, const std::string& solve) {
  return "kind = \"path-generation\"\n[target]\npoints = [[0, 0], [1, 0], [1, 1]]\n"
         "[constraints]\n" +
         constraints + "[solve]\n" + solve;
}

std::string function(const std::string& objective, const std::string& constraints,
                     const std::string& solve) {
  return "kind = \"function-generation\"\n[target]\nfunction = \"x^2\"\ndomain = [1, 2]\n"
         "input_range_deg = 60\noutput_range_deg = 90\n" +
         objective + "\n[constraints]\n" + constraints + "[solve]\n" + solve;
}

std::string motion(const std::string& more) {
  return "kind = \"motion-generation\"\n[target]\n"
         "poses = [[0, 0, 0], [1, 0, 10], [2, 1, 20], [2, 2, 40], [1, 3, 50], [0, 3, 70]]\n" +
         more;
}

template <class AnyProblem>
AnyProblem read(const std::string& text) {
  const auto problem = parse_task(text);
  if (!problem) {
    ADD_FAILURE() << problem.error().front().message;
    return {};
  }
  return std::get<AnyProblem>(*problem);
}

TEST(ObjectivesTest, AFrontHasTwelvePointsUnlessTheFileSaysHowMany) {
  const std::string crank = "class = \"crank-rocker\"\n";
  const std::string both = "objectives = [\"transmission_angle\", \"error\"]\n";
  const auto front = read<PathProblem>(path(crank, both)).solve;
  EXPECT_EQ(front.objectives, (std::vector<DesignObjective>{DesignObjective::transmission_angle,
                                                            DesignObjective::error}));
  EXPECT_EQ(front.designs, 12);
  EXPECT_EQ(read<PathProblem>(path(crank, both + "designs = 5\n")).solve.designs, 5);
  EXPECT_EQ(read<PathProblem>(path(crank, "")).solve.designs, 3);
  EXPECT_TRUE(read<PathProblem>(path(crank, "")).solve.objectives.empty());
  EXPECT_EQ(read<PathProblem>(path(crank, "objectives = [\"error\"]\n")).solve.designs, 3);
}

TEST(ObjectivesTest, TheErrorIsBoundedInItsOwnUnit) {
  const std::string ratio = "objectives = [\"link_ratio\"]\n";
  const auto length = read<PathProblem>(path("rms_error_max = 0.5\n", ratio));
  EXPECT_EQ(length.constraints.error->of, ErrorMeasure::rms_length);
  EXPECT_EQ(length.constraints.error->max, 0.5);
  EXPECT_EQ(length.solve.designs, 1);
  const auto angle = read<FunctionProblem>(function("", "rms_error_deg_max = 2\n", ratio));
  EXPECT_EQ(angle.constraints.error->of, ErrorMeasure::rms_angle);
  EXPECT_DOUBLE_EQ(angle.constraints.error->max, kTurn / 180);
  const auto largest =
      read<FunctionProblem>(function("objective = \"minimax\"", "max_error_deg_max = 2\n", ratio));
  EXPECT_EQ(largest.constraints.error->of, ErrorMeasure::largest_angle);
  const auto moved = read<MotionProblem>(motion("[constraints]\nrms_error_max = 1\n"));
  EXPECT_EQ(moved.constraints.error->max, 1);
}

const std::vector<FaultCase> kCases = {
    {"UnknownMeasure",
     path("", "objectives = [\"error\", \"eror\"]\n"),
     {{6, 24, "has \"eror\"; allowed are \"error\", \"transmission_angle\", \"link_ratio\""}}},
    {"Twice", path("", "objectives = [\"error\", \"error\"]\n"), {{6, 24, "twice"}}},
    {"Three",
     path("", "objectives = [\"error\", \"size\", \"link_ratio\"]\n"),
     {{6, 14, "expected 1 to 2"}}},
    {"TwoWithoutError",
     path("rms_error_max = 1\n", "objectives = [\"size\", \"link_ratio\"]\n"),
     {{7, 14, "expected \"error\" and one other"}}},
    {"OneWithoutBound",
     path("", "objectives = [\"size\"]\n"),
     {{6, 14, "expected constraints.rms_error_max"}}},
    {"TransmissionWithoutFullTurn",
     path("class = \"grashof\"\n", "objectives = [\"error\", \"transmission_angle\"]\n"),
     {{7, 14, "expected constraints.class = \"crank-rocker\" or \"double-crank\""}}},
    {"SizeOfAFunction",
     function("", "", "objectives = [\"error\", \"size\"]\n"),
     {{10, 14, "expected \"link_ratio\" or \"transmission_angle\""}}},
    {"BoundOfAnotherError",
     function("objective = \"minimax\"", "rms_error_deg_max = 1\n", ""),
     {{9, 21, "expected constraints.max_error_deg_max"}}},
    {"NegativeBound", path("rms_error_max = -1\n", ""), {{5, 17, "an error from"}}},
    {"WithLoss",
     path("", "objectives = [\"error\", \"size\"]\nloss = \"huber\"\nloss_scale = 1\n"),
     {{7, 8, "is given with solve.objectives"}}},
    {"WithCertificate",
     function("", "", "objectives = [\"error\", \"link_ratio\"]\ncertify = true\n"),
     {{11, 11, "a certificate is about the error alone"}}},
    {"WithCeres",
     path("", "objectives = [\"error\", \"size\"]\nsolver = \"ceres\"\n"),
     {{7, 10, "every other solver can"}}},
    {"FrontOfOne",
     path("", "objectives = [\"error\", \"size\"]\ndesigns = 1\n"),
     {{7, 11, "expected at least 2"}}},
    {"ManyBest",
     path("rms_error_max = 1\n", "objectives = [\"size\"]\ndesigns = 4\n"),
     {{8, 11, "remove it"}}},
    {"ExactPath",
     "kind = \"path-generation\"\n[target]\nmethod = \"exact\"\n"
     "points = [[0, 0], [1, 0], [2, 1], [2, 2], [1, 3]]\n[mechanism]\npivot_a = [0, 1]\n"
     "pivot_d = [1, 1]\n[solve]\nobjectives = [\"error\", \"size\"]\n",
     {{9, 14, "method = \"exact\""}}},
    {"ExactFunction",
     "kind = \"function-generation\"\n[target]\nfunction = \"x^2\"\ndomain = [1, 2]\n"
     "input_range_deg = 60\noutput_range_deg = 90\nprecision_points = 3\n[mechanism]\n"
     "input_start_deg = 10\noutput_start_deg = 20\n[constraints]\nrms_error_deg_max = 1\n",
     {{12, 21, "precision points"}}},
    {"MotionWithSliders",
     motion("[solve]\nobjectives = [\"error\", \"link_ratio\"]\n"),
     {{5, 14, "expected mechanism.dyads = [\"RR\"]"}}},
};

class ObjectivesFaultsTest : public ::testing::TestWithParam<FaultCase> {};

TEST_P(ObjectivesFaultsTest, EachAtItsPlace) {
  expect_faults(GetParam());
}

INSTANTIATE_TEST_SUITE_P(All, ObjectivesFaultsTest, ::testing::ValuesIn(kCases), name_of_case);

}  // namespace
}  // namespace cognate::problems::objectives_test
