// Closed curves in problem files: polylines, path data, drawings beside the file, and their faults.

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "analysis/numbers/constants.hpp"
#include "fault_cases.hpp"

namespace cognate::problems::path_curve_test {
namespace {

std::string with_target(const std::string& lines) {
  return "kind = \"path-generation\"\n[target]\n" + lines;
}

/// Out from a point and back again, in as many directions as samples are requested.
std::string spikes() {
  std::string text;
  for (int i = 0; i < 12; ++i) {
    const double angle = i * kPi / 6;
    text += fmt::format("{}[1, 1], [{:.17g}, {:.17g}]", i > 0 ? ", " : "",
                        1 + 0.5 * std::cos(angle), 1 + 0.5 * std::sin(angle));
  }
  return text;
}

PathProblem read_well(const std::string& text) {
  const auto problem = parse_task(text);
  if (problem) return std::get<PathProblem>(*problem);
  for (const Fault& fault : problem.error()) ADD_FAILURE() << fault.line << ": " << fault.message;
  return {};
}

TEST(PathCurve, APolylineIsSampledInEqualSteps) {
  const PathProblem problem = read_well(
      with_target("curve = [[0, 0], [4, 0], [4, 0], [4, 4], [0, 4], [0, 0]]\nsamples = 16\n"));
  ASSERT_TRUE(problem.curve);
  EXPECT_EQ(problem.curve->curve.vertices().size(), 4U);
  EXPECT_DOUBLE_EQ(problem.curve->curve.length(), 16);
  ASSERT_EQ(problem.points.size(), 16U);
  EXPECT_EQ(problem.points[5], (Vec2d{4, 1}));
  EXPECT_EQ(problem.weights, std::vector<double>(16, 1.0));
  EXPECT_EQ(problem.curve->place, CurvePlace::given);
  EXPECT_TRUE(problem.constraints.full_turn);
  EXPECT_TRUE(problem.constraints.no_extra_loop);
}

TEST(PathCurve, PathDataAreTurnedUpwards) {
  const PathProblem problem = read_well(with_target(
      "svg_path = \"M 0 0 h 4 v 4 h -4 z\"\nplace = \"similar\"\n[constraints]\nno_extra_loop = "
      "false\n"));
  ASSERT_TRUE(problem.curve);
  EXPECT_EQ(problem.points.size(), 80U);
  EXPECT_EQ(problem.points[30], (Vec2d{4, -2}));
  EXPECT_EQ(problem.curve->place, CurvePlace::similar);
  EXPECT_FALSE(problem.constraints.no_extra_loop);
}

const std::string kSquare = "curve = [[0, 0], [4, 0], [4, 4], [0, 4]]\n";

const FaultCase kFaults[] = {
    {"TwoPoints", with_target("curve = [[0, 0], [1, 0]]\n"), {{3, 9, "curve has 2 points"}}},
    {"TwoDifferentPoints",
     with_target("curve = [[0, 0], [1, 0], [0, 0], [1, 0]]\n"),
     {{3, 9, "fewer than 3 different points"}}},
    {"NoCurve", with_target("curve = 3\n"), {{3, 9, "expected an array of [x, y]"}}},
    {"NotFinite",
     with_target("curve = [[0, 0], [1, inf], [1, 1]]\n"),
     {{3, 22, "a number, 0 or of magnitude"}}},
    {"FarAway",
     with_target("curve = [[1e12, 0], [1000000000001.0, 0], [1e12, 1]]\n"),
     {{3, 9, "at a distance of up to"}}},
    {"PathData", with_target("svg_path = \"M 0 0 L 1 x\"\n"), {{3, 23, "has no number"}}},
    {"Open", with_target("svg_path = \"M 0 0 L 1 0 0 1\"\n"), {{3, 28, "expected a closed curve"}}},
    {"DrawingOfNoFile", with_target("svg = \"a.svg\"\n"), {{3, 7, "there is none; give svg_path"}}},
    {"TwoForms",
     with_target(kSquare + "svg_path = \"M 0 0 h 4 v 4 z\"\n"),
     {{4, 12, "is given beside curve"}}},
    {"PointsBeside",
     with_target(kSquare + "points = [[0, 0], [1, 0], [1, 1]]\nweights = [1, 1, 1]\n"),
     {{4, 10, "is given beside curve"}, {5, 11, "is given beside curve"}}},
    {"Timed",
     with_target(kSquare + "timing = \"prescribed\"\ncrank_deg = [0, 1]\n"),
     {{4, 10, "is not \"free\""}, {5, 13, "is given beside curve"}}},
    {"AnyOrder", with_target(kSquare + "order = \"any\"\n"), {{4, 9, "is not \"cyclic\""}}},
    {"Exact", with_target(kSquare + "method = \"exact\"\n"), {{4, 10, "no four-bar need meet"}}},
    {"IdWithoutDrawing", with_target(kSquare + "svg_id = \"a\"\n"), {{4, 10, "without svg"}}},
    {"FewSamples", with_target(kSquare + "samples = 5\n"), {{4, 11, "from 12 to 1000"}}},
    {"NoPlace", with_target(kSquare + "place = \"similiar\"\n"), {{4, 9, "similar"}}},
    {"SamplesOfPoints",
     with_target("points = [[0, 0], [1, 0], [1, 1]]\nsamples = 20\n"),
     {{4, 11, "without a closed curve"}}},
    {"SamplesOnOnePoint",
     with_target("samples = 12\ncurve = [" + spikes() + "]\n"),
     {{3, 11, "all fall on one point of the curve"}}},
    {"LoopOfPoints",
     with_target("points = [[0, 0], [1, 0], [1, 1]]\n[constraints]\nno_extra_loop = true\n"),
     {{5, 17, "no_extra_loop is given without a closed curve"}}},
    {"CrankThatRocks",
     with_target(kSquare + "[constraints]\nclass = \"double-rocker\"\n"),
     {{5, 9, "traced in a full turn"}}},
    {"LengthsThatRock",
     with_target(kSquare + "[mechanism]\ncrank = 5\nframe = 5\ncoupler = 1\n"),
     {{4, 1, "exclude a crank that turns fully"}}},
    {"Certified",
     with_target(kSquare + "[solve]\ncertify = true\n"),
     {{5, 11, "can be certified"}}},
    {"SimilarWithErrorLimit",
     with_target(kSquare + "place = \"similar\"\n[constraints]\nrms_error_max = 1\n"),
     {{6, 17, "take place = \"given\""}}},
    {"SimilarWithObjectives",
     with_target(kSquare + "place = \"similar\"\n[constraints]\nclass = \"crank-rocker\"\n"
                           "[solve]\nobjectives = [\"error\", \"link_ratio\"]\n"),
     {{8, 14, "take place = \"given\""}}},
    {"SimilarWithAWorkingEnvelope",
     with_target(kSquare + "place = \"similar\"\n[constraints]\nclass = \"crank-rocker\"\n"
                           "peak_acceleration_max = 3\n"),
     {{7, 25, "place = \"similar\""}}},
    {"SimilarWithPlaces",
     with_target(kSquare + "place = \"similar\"\n[mechanism]\ncoupler_point = [1, 1]\n[bounds]\n"
                           "pivot_a = [[0, 0], [1, 1]]\n[constraints]\npivot_region = [[0, 0], [1, "
                           "1]]\n"),
     {{6, 17, "place = \"similar\""}, {8, 11, "remove it"}, {10, 16, "remove it"}}},
};

class PathCurveFaults : public ::testing::TestWithParam<FaultCase> {};

TEST_P(PathCurveFaults, AreReportedAtTheirPlace) {
  expect_faults(GetParam());
}

INSTANTIATE_TEST_SUITE_P(All, PathCurveFaults, ::testing::ValuesIn(kFaults),
                         [](const auto& info) { return info.param.name; });

/// A folder with a problem file and a drawing.
class Drawings : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder =
        std::filesystem::temp_directory_path() / (std::string("cognate_drawings_") + test->name());
    std::filesystem::create_directories(folder);
  }
  void TearDown() override { std::filesystem::remove_all(folder); }

  auto read(const std::string& drawing, const std::string& more = "") {
    std::ofstream(folder / "a.svg") << drawing;
    std::ofstream(folder / "a.toml") << with_target("svg = \"a.svg\"\n" + more);
    return read_task(folder / "a.toml");
  }

  void expect_fault(const std::string& drawing, const std::string& says,
                    const std::string& more = "") {
    const auto problem = read(drawing, more);
    ASSERT_FALSE(problem) << drawing;
    EXPECT_NE(problem.error().front().message.find(says), std::string::npos)
        << problem.error().front().message;
    EXPECT_EQ(problem.error().front().line, 3U);
  }

  std::filesystem::path folder;
};

const std::string kTriangle = R"(<path id="t" d="M 0 0 H 3 V 4 Z"/>)";
const std::string kCircle = R"(<path id="c" d="M 1 0 A 1 1 0 0 0 -1 0 A 1 1 0 0 0 1 0 Z"/>)";

std::string svg(const std::string& content) {
  return "<?xml version=\"1.0\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\">" + content + "</svg>";
}

TEST_F(Drawings, TheOnlyPathThatIsDrawnIsTaken) {
  const auto problem = read(svg("<defs>" + kCircle + "</defs><g>" + kTriangle + "</g>"));
  ASSERT_TRUE(problem) << problem.error().front().message;
  const auto& curve = std::get<PathProblem>(*problem).curve;
  EXPECT_DOUBLE_EQ(curve->curve.length(), 12);
  EXPECT_EQ(curve->svg_path, "M 0 0 H 3 V 4 Z");
}

TEST_F(Drawings, OneOfSeveralIsChosenById) {
  const auto problem = read(svg(kTriangle + kCircle), "svg_id = \"c\"\n");
  ASSERT_TRUE(problem) << problem.error().front().message;
  EXPECT_NEAR(std::get<PathProblem>(*problem).curve->curve.length(), kTurn, 1e-6);
}

TEST_F(Drawings, APrefixedNamespaceIsRead) {
  EXPECT_TRUE(
      read("<s:svg xmlns:s=\"http://www.w3.org/2000/svg\"><s:path d=\"M0 0h1v1z\"/></s:svg>"));
}

TEST_F(Drawings, FaultsAreReportedAtTheKey) {
  expect_fault("", "is no XML");
  expect_fault("<svg><path d=\"M0 0", "is no XML at byte");
  expect_fault(svg("<circle r='1'/>"), "has no <path>");
  expect_fault(svg(kTriangle + kCircle),
               "has 2 paths; svg_id = \"...\" chooses by id, and ids are");
  expect_fault(svg(kTriangle), "no such <path> among 1; ids are \"t\"", "svg_id = \"u\"\n");
  expect_fault(svg("<g transform='scale(2)'>" + kTriangle + "</g>"), "has a transform");
  expect_fault(svg("<g style='transform:scale(2)'>" + kTriangle + "</g>"), "has a transform");
  expect_fault(svg("<path/>"), "draws nothing");
  expect_fault(svg("<path d='M 0 0 L 1 0 1 1'/>"), "expected a closed curve");
}

TEST_F(Drawings, WhatIsNoFileIsRefused) {
  std::ofstream(folder / "a.toml") << with_target("svg = \"none.svg\"\n");
  const auto missing = read_task(folder / "a.toml");
  ASSERT_FALSE(missing);
  EXPECT_NE(missing.error().front().message.find("\"none.svg\" is no file"), std::string::npos);
  std::ofstream(folder / "a.toml") << with_target("svg = \".\"\n");
  ASSERT_FALSE(read_task(folder / "a.toml"));
}

TEST_F(Drawings, DeepNestingIsWalkedWithoutHarm) {
  std::string deep;
  for (int i = 0; i < 100'000; ++i) deep += "<g>";
  deep += kTriangle;
  for (int i = 0; i < 100'000; ++i) deep += "</g>";
  EXPECT_TRUE(read(svg(deep)));
}

}  // namespace
}  // namespace cognate::problems::path_curve_test
