/// Robust designs judged by samples of the test's own: triangles by the law of cosines, a generator
/// and a nearest point that share nothing with the search.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "analysis/numbers/constants.hpp"
#include "problems/basics/quantity_key.hpp"
#include "problems/linkage/result.hpp"
#include "problems/read.hpp"
#include "tests/support/changed_four_bar.hpp"
#include "tests/support/folders.hpp"

namespace cognate::problems::robust_test {
namespace {

double fact(const Result& result, std::string_view name) {
  return find_quantity(result.quantities, QuantityKey<double>{name}).value_or(-1);
}

/// 99 % of the samples have no target farther than this from the curve near its crank angle.
double quantile(const FourBar& bar, const std::vector<double>& angles,
                const std::vector<Vec2d>& targets, double tolerance, bool timed) {
  constexpr int kSamples = 20'000;
  std::mt19937_64 random(99);
  std::normal_distribution<double> normal(0, tolerance / 3);
  std::vector<double> errors;
  for (int k = 0; k < kSamples; ++k) {
    std::vector<double> changes(6);
    for (double& change : changes) change = normal(random);
    errors.push_back(test::changed_path_error(bar, changes, angles, targets, timed ? 0 : 0.15));
  }
  std::ranges::sort(errors);
  return errors[static_cast<std::size_t>(0.99 * kSamples)];
}

TEST(RobustPaths, EllipseErrsFarLessThanTheNominalOptimum) {
  auto read = read_task(std::filesystem::path(kLibraryFolder) / "path/ellipse-robust.toml");
  ASSERT_TRUE(read);
  auto& problem = std::get<PathProblem>(*read);
  problem.solve.starts = 400;
  const Result result = solve(problem, {});
  ASSERT_EQ(result.status, Status::solved);
  const double robust = fact(result, "robust_quantile"), nominal = fact(result, "nominal_quantile");
  EXPECT_LT(robust, 0.3 * nominal);
  // The least that 400 descents of the mean square from random linkages led to, by another program.
  EXPECT_LT(robust, 0.14);
  const Design &first = result.designs.front(), &last = result.designs.back();
  // Of 20 000 samples the 99 % quantile is known to some percent.
  EXPECT_NEAR(quantile(four_bar(first), first.crank_angles, problem.points, 0.05, false), robust,
              0.04 * robust);
  EXPECT_NEAR(quantile(four_bar(last), last.crank_angles, problem.points, 0.05, false), nominal,
              0.04 * nominal);
  ASSERT_EQ(result.families.size(), 1U);
  const auto& columns = result.families.front().columns;
  EXPECT_TRUE(std::ranges::is_sorted(columns[0].values));
  EXPECT_TRUE(std::ranges::is_sorted(columns[1].values, std::ranges::greater{}));
}

/// A stop that comes while robust designs are sought: what is known by then, and no million
/// samples.
TEST(RobustPaths, ASearchThatIsStoppedJudgesByFewerSamples) {
  auto read = read_task(std::filesystem::path(kLibraryFolder) / "path/ellipse-robust.toml");
  ASSERT_TRUE(read);
  auto& problem = std::get<PathProblem>(*read);
  problem.solve.starts = 100;
  std::atomic<bool> stop = false;
  std::vector<double> shares;
  const Result result =
      solve(problem, {.threads = 1, .interrupted = &stop, .progress = [&](double share, double) {
                        if (share > 0.6) shares.push_back(share);  // of the search for robust ones
                        stop = share > 0.8;
                      }});
  EXPECT_EQ(result.status, Status::interrupted);
  EXPECT_TRUE(std::ranges::is_sorted(shares)) << testing::PrintToString(shares);
  EXPECT_GT(shares.size(), 3U);
  EXPECT_EQ(fact(result, "robust_samples"), 30'000);
  ASSERT_FALSE(result.designs.empty());
  const Design& first = result.designs.front();
  const double robust = fact(result, "robust_quantile");
  EXPECT_NEAR(quantile(four_bar(first), first.crank_angles, problem.points, 0.05, false), robust,
              0.05 * robust);
}

TEST(RobustPaths, TimedPathsAreNoWorseThanTheNominalOptimum) {
  const auto read = parse_task(
      "kind = \"path-generation\"\n[target]\npoints = [[0, 0], [1.9, 0.4], [3.1, 1.4], [3.4, 2.6], "
      "[2.8, 3.6], [1.5, 3.9]]\ntiming = \"prescribed\"\ncrank_deg = [0, 30, 60, 90, 120, 150]\n"
      "[bounds]\nlength = [0.5, 12]\n[tolerance]\nlength = 0.1\n[solve]\nrobust = 0.99\n"
      "starts = 100\n");
  ASSERT_TRUE(read);
  const auto& problem = std::get<PathProblem>(*read);
  const Result result = solve(problem, {});
  ASSERT_EQ(result.status, Status::solved);
  const double robust = fact(result, "robust_quantile"), nominal = fact(result, "nominal_quantile");
  EXPECT_LE(robust, nominal);
  const Design& first = result.designs.front();
  EXPECT_NEAR(quantile(four_bar(first), first.crank_angles, problem.points, 0.1, true), robust,
              0.04 * robust);
}

/// The angle of the rocker against A→D by the law of cosines.
double rocker_angle(double crank, double coupler, double rocker, double frame, Assembly assembly,
                    double angle) {
  const Vec2d to_b{crank * std::cos(angle) - frame, crank * std::sin(angle)};  // from D
  const double diagonal = std::hypot(to_b.x, to_b.y);
  const double at_d = std::acos((rocker * rocker + diagonal * diagonal - coupler * coupler) /
                                (2 * rocker * diagonal));
  const double way = std::atan2(to_b.y, to_b.x);
  return way + (assembly == Assembly::open ? -at_d : at_d);
}

TEST(RobustFunctions, TheSineErrsLessByHalf) {
  const auto read = parse_task(
      "kind = \"function-generation\"\n[target]\nfunction = \"sin(x)\"\ndomain = [0, \"pi/2\"]\n"
      "input_range_deg = 90\noutput_range_deg = 90\nsamples = 61\n[mechanism]\nframe = 1\n"
      "[bounds]\ncrank = [0.02, 50]\ncoupler = [0.02, 50]\nrocker = [0.02, 50]\n[tolerance]\n"
      "length = 0.01\n[solve]\nrobust = 0.99\nstarts = 40\n");
  ASSERT_TRUE(read);
  const Result result = solve(std::get<FunctionProblem>(*read), {});
  ASSERT_EQ(result.status, Status::solved);
  const double robust = fact(result, "robust_quantile_deg");
  const double nominal = fact(result, "nominal_quantile_deg");
  EXPECT_LT(robust, 0.55 * nominal);

  const Design& design = result.designs.front();
  const FourBar& bar = four_bar(design);
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal(0, 0.01 / 3);
  std::vector<double> errors;
  for (int k = 0; k < 20'000; ++k) {
    const double crank = bar.crank + normal(random), coupler = bar.coupler + normal(random);
    const double rocker = bar.rocker + normal(random), frame = 1 + normal(random);
    double greatest = 0;
    for (int i = 0; i <= 60; ++i) {
      const double x = kPi / 2 * i / 60;
      const double output = rocker_angle(crank, coupler, rocker, frame, bar.assembly,
                                         *design.metrics.input_start + x);
      const double wanted = *design.metrics.output_start + kPi / 2 * std::sin(x);
      greatest = std::max(greatest, std::abs(std::remainder(output - wanted, kTurn)));
    }
    errors.push_back(greatest / kDegree);
  }
  std::ranges::sort(errors);
  EXPECT_NEAR(errors[19'800], robust, 0.04 * robust);
}

TEST(RobustReading, RefusesWhatMakesNoSense) {
  const std::string head =
      "kind = \"path-generation\"\n[target]\npoints = [[0, 0], [1, 0.4], [1.5, 1]]\n";
  const auto fault = [](const std::string& text) {
    const auto problem = parse_task(text);
    return problem ? std::string() : problem.error().front().message;
  };
  EXPECT_NE(fault(head + "[solve]\nrobust = 0.99\n").find("tolerance"), std::string::npos);
  EXPECT_NE(fault(head + "[tolerance]\nlength = 0.1\n[solve]\nrobust = 1.2\n").find("robust"),
            std::string::npos);
  EXPECT_NE(fault(head + "[tolerance]\nlength = 0.1\npivots = 0.1\n[solve]\nrobust = 0.9\n")
                .find("pivots"),
            std::string::npos);
  EXPECT_NE(fault(head + "[tolerance]\nlength = 0.1\n[raster]\nlength = 1\n[solve]\nrobust = 0.9\n")
                .find("raster"),
            std::string::npos);
}

}  // namespace
}  // namespace cognate::problems::robust_test
