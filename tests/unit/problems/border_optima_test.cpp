/// Optima at the border of two classes, where limits of the transmission angle are other ones: the
/// search for any class is no worse than those for each class by itself. And the best is one that
/// meets its limit, by the law of cosines.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "analysis/numbers/constants.hpp"
#include "problems/basics/degrees.hpp"
#include "problems/function/problem.hpp"
#include "problems/guidance/problem.hpp"
#include "problems/linkage/result.hpp"
#include "problems/linkage/verify.hpp"
#include "problems/path/problem.hpp"
#include "problems/read.hpp"

namespace cognate::problems::border_optima_test {
namespace {

constexpr std::array kClasses{"crank-rocker", "double-crank", "rocker-crank", "double-rocker",
                              "triple-rocker"};

template <class Problem>
Result solved(const std::string& text, std::uint64_t seed = 1) {
  const auto problem = parse_task<Problem>(text);
  EXPECT_TRUE(problem) << problem.error().front().message;
  return problem ? solve(*problem, {.seed = seed, .threads = 2}) : Result{};
}

/// `greatest`: by the greatest error, not by the root mean square.
double error_of(const Result& result, bool greatest) {
  if (result.status != Status::solved) return kInfinity;
  const auto& error = result.designs.front().error;
  return greatest ? error.max : error.rms;
}

/// `text` ends with its constraints.
template <class Problem>
Result no_worse_than_in_any_class(const std::string& text, bool greatest = false) {
  const Result result = solved<Problem>(text);
  for (const char* name : kClasses) {
    const Result confined = solved<Problem>(text + fmt::format("class = \"{}\"\n", name));
    EXPECT_LE(error_of(result, greatest), error_of(confined, greatest) * (1 + 1e-3)) << name;
  }
  return result;
}

std::string function(const std::string& target, const std::string& limits) {
  return "kind = \"function-generation\"\n[target]\n" + target +
         "samples = 21\n[mechanism]\nframe = 1\n[constraints]\n" + limits;
}

TEST(BorderOptima, OfFunctionsByLeastSquares) {
  const auto result = no_worse_than_in_any_class<FunctionProblem>(function(
      "function = \"1/x\"\ndomain = [1, 2]\ninput_range_deg = 120\noutput_range_deg = 40\n",
      "transmission_angle_deg = [50, 130]\n"));
  ASSERT_EQ(result.status, Status::solved);
  const Design& design = result.designs.front();
  EXPECT_LT(design.error.rms, 0.0016);
  const auto links = lengths(four_bar(design));
  for (int k = 0; k <= 120; ++k) {
    const double crank = *design.metrics.input_start + k * kDegree;
    const double square = links.crank * links.crank + links.frame * links.frame -
                          2 * links.crank * links.frame * std::cos(crank);
    const double cosine = (links.coupler * links.coupler + links.rocker * links.rocker - square) /
                          (2 * links.coupler * links.rocker);
    EXPECT_LE(std::abs(cosine), std::cos(50 * kDegree) + 1e-9) << k;
  }
}

TEST(BorderOptima, OfFunctionsByTheirGreatestError) {
  const auto result = no_worse_than_in_any_class<FunctionProblem>(
      function("function = \"log10(x)\"\ndomain = [1, 2]\ninput_range_deg = 90\noutput_range_deg = "
               "40\nobjective = \"minimax\"\n",
               "transmission_angle_deg = [50, 130]\nlink_ratio_max = 4\n"),
      true);
  EXPECT_EQ(result.status, Status::solved);
}

/// Starts of the least error exceed the limit: those that keep within it lead to the best.
TEST(BorderOptima, OfFunctionsWhoseBestStartsExceedTheLimit) {
  const auto result = no_worse_than_in_any_class<FunctionProblem>(
      function("function = \"x^1.5\"\ndomain = [0, 1]\ninput_range_deg = 60\noutput_range_deg = "
               "60\nobjective = \"minimax\"\n",
               "transmission_angle_deg = [50, 130]\n"),
      true);
  EXPECT_EQ(result.status, Status::solved);
}

TEST(BorderOptima, OfMotions) {
  const auto result = no_worse_than_in_any_class<MotionProblem>(
      "kind = \"motion-generation\"\n[target]\nmethod = \"least-squares\"\nposes = [[0, 0, 0], "
      "[1.022, -0.545, 3.8], [1.928, -0.09, 13.85], [2.87, 0.492, 22.67], [3.454, 0.493, 27.79], "
      "[4.421, 0.272, 42.62], [5.445, 0.325, 56.72], [6.181, 0.446, 56.7]]\n[mechanism]\ndyads = "
      "[\"RR\"]\n[constraints]\ntransmission_angle_deg = [40, 140]\n");
  EXPECT_EQ(result.status, Status::solved);
}

TEST(BorderOptima, OfTimedPaths) {
  const auto result = no_worse_than_in_any_class<PathProblem>(
      "kind = \"path-generation\"\n[target]\npoints = [[0.7467, 1.2037], [0.4147, 1.2519], "
      "[0.0795, "
      "1.221], [-0.2216, 1.1943], [-0.463, 1.2123], [-0.6342, 1.2487], [-0.739, 1.2257], [-0.7922, "
      "1.0594], [-0.8128, 0.711], [-0.8182, 0.2152], [-0.8177, -0.3288], [-0.8102, -0.7998]]\n"
      "timing = \"prescribed\"\ncrank_deg = [0, 14.3239, 28.6479, 42.9718, 57.2958, 71.6197, "
      "85.9437, 100.2676, 114.5916, 128.9155, 143.2394, 157.5634]\n[constraints]\n"
      "transmission_angle_deg = [40, 140]\n");
  EXPECT_EQ(result.status, Status::solved);
}

/// A planted triple-rocker: points that are not timed lie where the transmission angle exceeds its
/// limit by a tenth of a degree, unless the limit is narrowed.
TEST(BorderOptima, WherePointsThatAreNotTimedExceedALimitByLittle) {
  constexpr double kPlantedSquares = 2.8083574854662344e-06;
  for (const std::uint64_t seed : {1, 3}) {
    const Result result = solved<PathProblem>(
        "kind = \"path-generation\"\n[target]\npoints = [[1.6975049567107643, "
        "-0.8826871411989075], [1.6018468223224305, -0.9469781811578921], [1.532643812396854, "
        "-0.9817001271832249], [0.9152666701425262, -0.9304245068091626], [0.8652676695677579, "
        "-0.8862876234670627], [0.7756381768509972, -0.3788251359284918], [0.7817265287642217, "
        "-0.3622500471001686], [0.9964209009647053, -0.08508484460422609]]\ntiming = "
        "\"mixed\"\ncrank_deg = [0.0, \"free\", \"free\", \"free\", 59.32321055751953, \"free\", "
        "\"free\", \"free\"]\ncrank_sense = \"cw\"\n[constraints]\nclass = "
        "\"triple-rocker\"\ntransmission_angle_deg = [58.435219364808454, "
        "80.6585892003361]\npivot_region = [[0.6137525764352463, -0.2666228387266124], "
        "[2.1316575454679576, 0.5921475880553669]]\n",
        seed);
    ASSERT_EQ(result.status, Status::solved) << seed;
    EXPECT_LE(result.designs.front().error.sum_of_squares, kPlantedSquares) << seed;
  }
}

/// The frame is a third of the crank given, and the ratio of the coupler to it is at its limit:
/// what the search leaves of that limit counts relative to the frame. Outputs of a four-bar of
/// lengths 1, 1.2333, 0.5665 and 0.3456, which meets everything, with noise of 0.1 percent.
TEST(BorderOptima, WhereALimitIsThatOfTheLeastLink) {
  const auto result = solved<FunctionProblem>(
      "kind = \"function-generation\"\n[target]\npairs_deg = ["
      "[0, 0], [2.55, 1.19], [5.09, 2.36], [7.64, 3.49], [10.18, 4.58], [12.73, 5.64], "
      "[15.28, 6.69], [17.82, 7.68], [20.37, 8.68], [22.92, 9.63], [25.46, 10.59], [28.01, "
      "11.46], [30.55, 12.35], [33.1, 13.22], [35.65, 14.12], [38.19, 14.93], [40.74, 15.72], "
      "[43.28, 16.49], [45.83, 17.24], [48.38, 18], [50.92, 18.75]"
      "]\n[bounds]\ncoupler = [0.05, 20]\nrocker = [0.05, 20]\nframe = [0.05, 20]\n[constraints]\n"
      "class = \"triple-rocker\"\ntransmission_angle_deg = [54.506, 83.028]\n"
      "link_ratio_max = 3.925\n");
  ASSERT_EQ(result.status, Status::solved);
  const auto [crank, coupler, rocker, frame] = lengths(four_bar(result.designs.front()));
  EXPECT_NEAR(std::max({crank, coupler, rocker}) / frame, 3.925, 1e-6);
}

/// The best linkage of these noisy pairs comes to the edge of what closes between two samples:
/// beyond it, it has a circuit defect. Each seed finds it, and within.
TEST(BorderOptima, WhereTheLinkageHardlyClosesBetweenSamples) {
  for (const std::uint64_t seed : {1, 2}) {
    const Result result = solved<FunctionProblem>(
        "kind = \"function-generation\"\n[target]\nobjective = \"minimax\"\npairs_deg = ["
        "[0, 0], [2.2, 8.1], [4.3, 4.1], [6.5, 6.2], [8.6, 7.3], [10.8, 11.1], [12.9, 11.3], "
        "[15.1, 16.3], [17.2, 9.6], [19.4, 12.8], [21.5, 20.3], [23.7, 21.2], [25.8, 23.1], "
        "[28, 20], [30.1, 18.4], [32.3, 26.7], [34.5, 24.3], [36.6, 24.2], [38.8, 23], [40.9, "
        "30.7], [43.1, 31.7], [45.2, 26.8], [47.4, 31], [49.5, 34.7], [51.7, 32], [53.8, "
        "42.2], [56, 34.7], [58.1, 37.4], [60.3, 36.2], [62.4, 37.7], [64.6, 47], [66.7, "
        "42.4], [68.9, 40.7], [71.1, 47.7], [73.2, 47.3], [75.4, 47.2], [77.5, 45.9], [79.7, "
        "50.6], [81.8, 51.7], [84, 49.8], [86.1, 54.7]"
        "]\n[bounds]\ncoupler = [0.05, 20]\nrocker = [0.05, 20]\nframe = [0.05, 20]\n",
        seed);
    ASSERT_EQ(result.status, Status::solved) << seed;
    constexpr double kBest = 4.70492;  // degrees, by differential evolution over the law of cosines
    EXPECT_LE(degrees(result.designs.front().error.max), kBest) << seed;
    const auto [crank, coupler, rocker, frame] = lengths(four_bar(result.designs.front()));
    EXPECT_LT(crank + frame, coupler + rocker) << seed;
  }
}

}  // namespace
}  // namespace cognate::problems::border_optima_test
