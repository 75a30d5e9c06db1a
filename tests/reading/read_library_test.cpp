// The problems of the library parse, and mean what their sources say.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "problems/read.hpp"
#include "tests/support/folders.hpp"

namespace cognate::problems::read_library_test {
namespace {

const std::filesystem::path kLibrary = kLibraryFolder;

Task read_or_fail(const std::filesystem::path& file) {
  const auto problem = read_task(file);
  if (problem) return *problem;
  for (const Fault& fault : problem.error()) {
    ADD_FAILURE() << file << ":" << fault.line << ":" << fault.column << ": " << fault.message;
  }
  return {};
}

PathProblem path(const std::string& name) {
  return std::get<PathProblem>(read_or_fail(kLibrary / "path" / (name + ".toml")));
}

FunctionProblem function(const std::string& name) {
  return std::get<FunctionProblem>(read_or_fail(kLibrary / "function" / (name + ".toml")));
}

TEST(ReadLibraryTest, EveryFileIsATask) {
  int count = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(kLibrary)) {
    if (entry.path().extension() != ".toml") continue;
    if (entry.path().parent_path().filename() == "study") continue;  // has many tasks
    EXPECT_TRUE(read_task(entry.path())) << entry.path();
    ++count;
  }
  EXPECT_GE(count, 30);
}

TEST(ReadLibraryTest, EveryPathByLeastSquaresAsksForACrankRocker) {
  int tested = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kLibrary / "path")) {
    if (entry.path().extension() != ".toml") continue;
    const auto problem = std::get<PathProblem>(read_or_fail(entry.path()));
    if (problem.method == PathMethod::exact) continue;
    ++tested;
    const bool any_class = problem.solve.robust.has_value();  // is sought among all
    EXPECT_EQ(problem.constraints.required_class,
              any_class ? std::nullopt : std::optional(RequiredClass::crank_rocker))
        << entry.path();
    EXPECT_EQ(problem.weights.size(), problem.points.size()) << entry.path();
    EXPECT_FALSE(problem.title.empty()) << entry.path();
  }
  EXPECT_GE(tested, 15);
}

TEST(ReadLibraryTest, PointsOfAMixedPathAreTimedWhereTheFileSaysSo) {
  const PathProblem problem = path("walking-leg");
  EXPECT_EQ(problem.timing, Timing::mixed);
  ASSERT_EQ(problem.points.size(), 8u);
  for (std::size_t j = 0; j < 8; ++j) {
    EXPECT_EQ(problem.is_timed(j), j < 5);
    EXPECT_EQ(problem.weights[j], j < 5 ? 10 : 1);
    if (j < 5) {
      EXPECT_DOUBLE_EQ(problem.crank_angles[j], 45.0 * double(j) * kDegree);
    }
  }
}

TEST(ReadLibraryTest, ExactPathsTakePosesFirst) {
  const PathProblem nine = path("nine-points-3");
  EXPECT_EQ(nine.method, PathMethod::exact);
  EXPECT_EQ(nine.points.size(), 9u);
  EXPECT_EQ(nine.order, PointOrder::cyclic);
  EXPECT_GT(nine.solve.designs, 6 * 64);  // all of them
  const PathProblem mixed = path("poses-and-points");
  ASSERT_EQ(mixed.pose_angles.size(), 3u);
  EXPECT_DOUBLE_EQ(mixed.pose_angles[0], 0);
  EXPECT_EQ(mixed.points.size(), 7u);
  EXPECT_EQ(mixed.order, PointOrder::any);
}

TEST(ReadLibraryTest, SixPointLine) {
  const PathProblem problem = path("six-point-line");
  ASSERT_EQ(problem.points.size(), 6U);
  EXPECT_EQ(problem.points.back(), (Vec2d{20, 45}));
  EXPECT_EQ(problem.timing, Timing::free);
  EXPECT_EQ(problem.order, PointOrder::cyclic);
  for (const auto& length : {problem.bounds.crank, problem.bounds.coupler, problem.bounds.rocker,
                             problem.bounds.frame}) {
    ASSERT_TRUE(length);
    EXPECT_EQ(length->min, 5);
    EXPECT_EQ(length->max, 60);
  }
  ASSERT_TRUE(problem.bounds.pivot_a && problem.bounds.coupler_point);
  EXPECT_EQ(problem.bounds.pivot_a->min, (Vec2d{-60, -60}));
  EXPECT_FALSE(problem.bounds.pivot_d);
}

TEST(ReadLibraryTest, FivePointArc) {
  const PathProblem problem = path("five-point-arc");
  EXPECT_EQ(problem.timing, Timing::prescribed);
  EXPECT_EQ(problem.crank_reference, CrankReference::frame);
  ASSERT_EQ(problem.crank_angles.size(), 5U);
  EXPECT_DOUBLE_EQ(problem.crank_angles[0], 30 * kDegree);
  EXPECT_DOUBLE_EQ(problem.crank_angles[4], 90 * kDegree);
  EXPECT_EQ(problem.given.pivot_a, (Vec2d{0, 0}));
  EXPECT_EQ(problem.given.frame_angle, 0.0);
}

TEST(ReadLibraryTest, EighteenPoints) {
  const PathProblem problem = path("eighteen-points");
  ASSERT_EQ(problem.points.size(), 18U);
  ASSERT_EQ(problem.crank_angles.size(), 18U);
  for (int i = 0; i < 18; ++i) EXPECT_DOUBLE_EQ(problem.crank_angles[i], 20 * i * kDegree);
  EXPECT_EQ(problem.crank_reference, CrankReference::first);
  EXPECT_EQ(problem.crank_sense, CrankSense::ccw);
}

TEST(ReadLibraryTest, EllipseRepeatsItsFirstPoint) {
  const PathProblem problem = path("ten-point-ellipse");
  ASSERT_EQ(problem.points.size(), 10U);
  EXPECT_EQ(problem.points.front(), problem.points.back());
}

TEST(ReadLibraryTest, TextbookPaths) {
  const PathProblem ten = path("textbook-ten-points");
  ASSERT_TRUE(ten.constraints.transmission_angle);
  EXPECT_DOUBLE_EQ(ten.constraints.transmission_angle->min, 30 * kDegree);
  EXPECT_DOUBLE_EQ(ten.constraints.transmission_angle->max, 150 * kDegree);
  EXPECT_FALSE(ten.bounds.crank);
  const PathProblem eight = path("textbook-eight-points");
  EXPECT_EQ(eight.crank_sense, CrankSense::either);
  EXPECT_DOUBLE_EQ(eight.crank_angles.back(), 314 * kDegree);
}

TEST(ReadLibraryTest, ThreeAnglePairs) {
  const FunctionProblem problem = function("three-angle-pairs");
  const auto& pairs = std::get<AnglePairs>(problem.target);
  ASSERT_EQ(pairs.size(), 3U);
  EXPECT_DOUBLE_EQ(pairs[2].first, 135 * kDegree);
  EXPECT_DOUBLE_EQ(pairs[2].second, 110 * kDegree);
  EXPECT_EQ(problem.objective, FunctionObjective::exact);
  EXPECT_EQ(problem.precision_points, 3);
  EXPECT_EQ(problem.input_start, 0.0);
  EXPECT_EQ(problem.output_start, 0.0);
  EXPECT_EQ(problem.given.crank, 1.0);
  EXPECT_TRUE(problem.sample_at.empty());
}

TEST(ReadLibraryTest, Logarithm) {
  const FunctionProblem exact = function("log10");
  const auto& target = std::get<FunctionOfX>(exact.target);
  EXPECT_EQ(target.text, "log10(x)");
  EXPECT_DOUBLE_EQ(target.y(2), std::log10(2.0));
  EXPECT_EQ(exact.objective, FunctionObjective::exact);
  EXPECT_EQ(exact.precision_points, 3);
  EXPECT_DOUBLE_EQ(exact.input_start.value(), 86 * kDegree);
  EXPECT_DOUBLE_EQ(exact.output_start.value(), 23.5 * kDegree);
  ASSERT_TRUE(target.input_range && target.output_range);
  EXPECT_DOUBLE_EQ(*target.input_range, 60 * kDegree);
  EXPECT_DOUBLE_EQ(*target.output_range, 90 * kDegree);

  const FunctionProblem refined = function("log10-refined");
  EXPECT_EQ(refined.objective, FunctionObjective::least_squares);
  EXPECT_FALSE(refined.input_start || refined.output_start);
  EXPECT_EQ(refined.precision_points, 0);
  ASSERT_EQ(refined.sample_at.size(), 61U);
  EXPECT_EQ(refined.sample_at.front(), 1);
  EXPECT_EQ(refined.sample_at.back(), 2);
  EXPECT_EQ(refined.given.crank, 1.0) << "the default scale";
}

TEST(ReadLibraryTest, ExactGenerators) {
  const FunctionProblem five = function("five-angle-pairs");
  EXPECT_EQ(five.precision_points, 5);
  EXPECT_FALSE(five.input_start || five.output_start);
  const FunctionProblem four = function("sine-four-points");
  EXPECT_EQ(four.precision_points, 4);
  EXPECT_EQ(four.best_by, BestBy::error);
  const FunctionProblem close = function("logarithm-by-derivatives");
  EXPECT_EQ(close.at, (std::vector<double>{1, 1.5, 2}));
  EXPECT_EQ(close.multiplicity, (std::vector<int>{1, 3, 1}));
  EXPECT_EQ(close.precision_points, 5);
}

TEST(ReadLibraryTest, SliderCrankGenerators) {
  const FunctionProblem pairs = function("slider-crank-pairs");
  EXPECT_EQ(pairs.type, MechanismType::slider_crank);
  EXPECT_EQ(pairs.output_start, 0.0);
  const auto& places = std::get<AnglePairs>(pairs.target);
  EXPECT_DOUBLE_EQ(places[0].first, 20 * kDegree);
  EXPECT_EQ(places[0].second, 157.580453473);
  const FunctionProblem square = function("slider-crank-square");
  EXPECT_EQ(std::get<FunctionOfX>(square.target).output_range, 100.0);
  EXPECT_FALSE(square.given.crank) << "displacements give the scale";
}

TEST(ReadLibraryTest, CrankRockerParabola) {
  const FunctionProblem problem = function("crank-rocker-parabola");
  const auto& target = std::get<FunctionOfX>(problem.target);
  EXPECT_FALSE(target.input_range || target.output_range);
  ASSERT_EQ(problem.sample_at.size(), 30U);
  for (int i = 0; i < 30; ++i) {
    const double x = 3 * (i + 1) * kDegree;
    EXPECT_DOUBLE_EQ(problem.sample_at[i], x);
    EXPECT_DOUBLE_EQ(target.y(x), 2 / (3 * kPi) * x * x);
  }
  EXPECT_EQ(problem.start, FunctionStart::outer_dead_centre);
  EXPECT_EQ(problem.given.crank, 1.0);
  EXPECT_EQ(problem.given.frame, 5.0);
  ASSERT_TRUE(problem.bounds.coupler);
  EXPECT_EQ(problem.bounds.coupler->min, 1);
  EXPECT_TRUE(std::isinf(problem.bounds.coupler->max));
  EXPECT_EQ(problem.constraints.required_class, RequiredClass::crank_rocker);
}

// Tables are sampled at their own x, and where samples = N requires others, between them.
TEST(ReadFunctionTest, TableSamples) {
  const std::string head =
      "kind = \"function-generation\"\n[target]\ntable = [[0, 0], [1, 1], [4, 2]]\n"
      "input_range_deg = 60\noutput_range_deg = -60\n";
  const auto own = parse_task(head);
  ASSERT_TRUE(own);
  EXPECT_EQ(std::get<FunctionProblem>(*own).sample_at, (std::vector<double>{0, 1, 4}));
  const auto five = parse_task(head + "[solve]\nsamples = 5\n");
  ASSERT_TRUE(five);
  const auto& problem = std::get<FunctionProblem>(*five);
  EXPECT_EQ(problem.sample_at, (std::vector<double>{0, 1, 2, 3, 4}));
  const auto& target = std::get<FunctionOfX>(problem.target);
  EXPECT_GT(target.y(2), 1);
  EXPECT_LT(target.y(2), target.y(3));
  EXPECT_LT(*target.output_range, 0);
}

// Derivatives stand for further pairs.
TEST(ReadFunctionTest, DerivativesOfPairs) {
  const auto problem = parse_task(
      "kind = \"function-generation\"\n[target]\npairs_deg = [[0, 0], [40, 30]]\n"
      "derivatives = [[], [1, 0.5]]\nprecision_points = 4\n[mechanism]\noutput_start_deg = 5\n");
  ASSERT_TRUE(problem);
  const auto& read = std::get<FunctionProblem>(*problem);
  EXPECT_EQ(read.derivatives, (std::vector<std::vector<double>>{{}, {1, 0.5}}));
  EXPECT_EQ(read.precision_points, 4);
  EXPECT_FALSE(read.input_start);
}

// Exact pairs without start angles are angles from the frame line.
TEST(ReadFunctionTest, ExactPairsStartAtTheFrame) {
  const auto problem = parse_task(
      "kind = \"function-generation\"\n[target]\npairs_deg = [[1, 2], [3, 4], [5, 7]]\n"
      "objective = \"exact\"\n");
  ASSERT_TRUE(problem);
  EXPECT_EQ(std::get<FunctionProblem>(*problem).input_start, 0.0);
  EXPECT_EQ(std::get<FunctionProblem>(*problem).precision_points, 3);
}

}  // namespace
}  // namespace cognate::problems::read_library_test
