/// The greatest error of a function generator against that at a great many places of its domain.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "analysis/linkage/motion.hpp"
#include "analysis/numbers/constants.hpp"
#include "problems/function/generator.hpp"
#include "problems/function/target/fast_places.hpp"
#include "problems/read.hpp"

namespace cognate::problems::function_peaks_test {
namespace {

FunctionProblem problem_of(const std::string& function, const std::string& domain) {
  const auto problem = parse_task<FunctionProblem>(
      "kind = \"function-generation\"\n[target]\nfunction = \"" + function + "\"\ndomain = " +
      domain + "\ninput_range_deg = 90\noutput_range_deg = 60\n[solve]\nstarts = 1\n");
  EXPECT_TRUE(problem) << (problem ? "" : problem.error()[0].message);
  return *problem;
}

/// A linkage that closes over 90° from its start, its output start anything.
FunctionGenerator random_generator(std::mt19937_64& random) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (;;) {
    FunctionGenerator made{{uniform(0.3, 2), uniform(0.3, 2), uniform(0.3, 2), uniform(0.3, 2)},
                           random() % 2 ? Assembly::open : Assembly::crossed,
                           uniform(-3, 3)};
    if (!StructuralError(made).closes_over({0, kPi / 2})) continue;
    made.output_start = Motion(four_bar(made)).at(made.input_start)->rocker_angle;
    return made;
  }
}

/// Greatest distance of the output from the function at so many equal steps.
double brute_force(const FunctionGenerator& made, const FunctionProblem& problem, int steps) {
  const auto& target = std::get<FunctionOfX>(problem.target);
  const auto [from, to] = target.domain;
  const double y0 = target.y(from), per_y = *target.output_range / (target.y(to) - y0);
  const Motion motion(four_bar(made));
  double greatest = 0;
  for (int k = 0; k <= steps; ++k) {
    const double share = double(k) / steps;
    const auto pose = motion.at(made.input_start + share * *target.input_range);
    if (!pose) continue;
    const double wanted = per_y * (target.y(from + share * (to - from)) - y0);
    const double away = pose->rocker_angle - made.output_start - wanted;
    greatest = std::max(greatest, std::abs(std::remainder(away, kTurn)));
  }
  return greatest;
}

TEST(FunctionPeaks, AreNoLowerThanByBruteForce) {
  // Outputs stay within half a turn, beyond which an error wraps.
  const std::vector<std::pair<std::string, std::string>> fast = {
      {"sin(1/x) + 3*x", "[0.02, 1]"},
      {"cos(300*x) + 4*x", "[0, 1]"},
      {"sqrt(x)", "[0, 1]"},
      {"abs(x - 0.31234) + x/5", "[0, 1]"},
      {"exp(-(1e3*(x-0.4711))^2) + 2*x", "[0, 1]"},
      {"x + sin(exp(6*x))", "[0, 1]"},
      {"log10(x)", "[1, 2]"}};
  std::mt19937_64 random(3);
  int tested = 0;
  for (const auto& [function, domain] : fast) {
    const FunctionProblem problem = problem_of(function, domain);
    const FunctionSamples wanted = function_samples(problem);
    for (int trial = 0; trial < 4; ++trial, ++tested) {
      const FunctionGenerator made = random_generator(random);
      const double found = StructuralError(made).over(wanted).max;
      const double brute = brute_force(made, problem, 200'000);
      EXPECT_GE(found, brute * (1 - 1e-9)) << function << ' ' << trial;
      EXPECT_LE(found, brute * (1 + 1e-4)) << function << ' ' << trial;
    }
  }
  EXPECT_EQ(tested, 28);
}

TEST(FunctionPeaks, PlacesLieWhereTheFunctionIsFast) {
  // Of ordinary functions there are none.
  EXPECT_TRUE(fast_places([](double x) { return std::exp(x); }, 200).empty());
  EXPECT_TRUE(fast_places([](double x) { return std::log10(1 + x); }, 200).empty());
  EXPECT_TRUE(fast_places([](double x) { return std::sin(3 * x); }, 200).empty());
  EXPECT_TRUE(fast_places([](double) { return 2.0; }, 200).empty());
  // A kink is closed in on from both sides, and from nowhere else.
  const double kink = 0.3217;
  const auto about = fast_places([&](double x) { return std::abs(x - kink); }, 200);
  ASSERT_FALSE(about.empty());
  EXPECT_LE(about.size(), 60U);
  const auto nearest = std::ranges::min(about, {}, [&](double x) { return std::abs(x - kink); });
  EXPECT_NEAR(nearest, kink, 5e-8);
  EXPECT_TRUE(std::ranges::all_of(about, [&](double x) { return std::abs(x - kink) < 0.005; }));
  // Zeros of a sine at the ends of all steps.
  EXPECT_GT(fast_places([](double x) { return std::sin(200 * kPi * x); }, 200).size(), 2000U);
  // Noise ends with the most places.
  std::mt19937_64 random(1);
  EXPECT_EQ(fast_places([&](double) { return double(random() % 1000); }, 200).size(), 10'000U);
}

}  // namespace
}  // namespace cognate::problems::function_peaks_test
